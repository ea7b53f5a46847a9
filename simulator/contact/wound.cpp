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
  double least_mm = std::numeric_limits<double>::infinity();
  visit_near(point_in_wound_mm, least_mm, [&](std::int32_t, const WoundFragment& standing) {
    const Vec3 point_mm = standing.point_from(point_in_wound_mm);
    least_mm = std::min(least_mm, standing.tissue.clearance_mm(point_mm));
  });
  return least_mm;
}

}  // namespace hallux::simulator
