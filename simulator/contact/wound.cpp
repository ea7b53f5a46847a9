#include "simulator/contact/wound.h"

#include <limits>

namespace hallux::simulator {

Wound::Wound(const RemainingTissue& only) noexcept : kerfs_(&only.kerfs.all()) {
  fragments_[0].emplace(WoundFragment{only, {}, {}, false, {}, 0.0});
  end_ = 1;
}

void Wound::put(std::int32_t fragment, const WoundFragment& standing) noexcept {
  fragments_[static_cast<std::size_t>(fragment)].emplace(standing);
  end_ = std::max(end_, fragment + 1);
}

KerfPlane Wound::plane(std::int32_t kerf) const noexcept {
  const KerfPlane& plane = kerfs_->plane(kerf);
  return {fragment_of_kerf(kerf).wound_from(plane.bone_from_kerf), plane.thickness_mm};
}

double Wound::clearance_mm(const Vec3& point_in_wound_mm) const noexcept {
  OfFragments<SurfaceMemory> nothing;
  return clearance_mm(point_in_wound_mm, nothing);
}

double Wound::clearance_mm(const Vec3& point_in_wound_mm,
                           OfFragments<SurfaceMemory>& memory) const noexcept {
  double least_mm = std::numeric_limits<double>::infinity();
  visit_near(point_in_wound_mm, least_mm, [&](std::int32_t number, const WoundFragment& standing) {
    const Vec3 point_mm = standing.point_from(point_in_wound_mm);
    const Bvh& surface = standing.tissue.surface();
    SurfaceMemory& known = memory[static_cast<std::size_t>(number)];
    if (known.is_known && known.clearance_mm - known.moved_mm(point_mm) >= least_mm) return;
    if (surface.outside_box_mm(point_mm) >= least_mm) return;
    known = {point_mm, clearance_by_memory(surface, point_mm, known), true};
    least_mm = std::min(least_mm, known.clearance_mm);
  });
  return least_mm;
}

}  // namespace hallux::simulator
