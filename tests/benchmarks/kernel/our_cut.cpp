#include "tests/benchmarks/kernel/our_cut.h"

#include "tests/benchmarks/report/percentiles.h"

namespace hallux::benchmarks {

using namespace simulator;

OurCut::OurCut(const CutSolid& solid, const Bvh& bvh, const KerfPlane& plane, KerfField& field,
               std::int32_t kerf)
    : field_(field),
      contact_(slice_slab(solid, bvh, plane, kerf, field.grid())),
      builder_(contact_),
      tracker_(field.grid()) {}

bool OurCut::advance(const Blade& blade, const PlanarPose& to) {
  const Stopwatch watch;
  FieldWindow changed;
  field_.stamp(blade, has_pose_ ? from_ : to, to, changed);
  from_ = to;
  has_pose_ = true;
  if (changed.is_empty()) return false;
  const double stamped_ms = watch.worked_milliseconds();
  tracker_.update(field_);
  const double outlined_ms = watch.worked_milliseconds();
  builder_.build(tracker_.outline(), patch_);
  const double built_ms = watch.worked_milliseconds();
  fill_buffers();
  parts_ = {stamped_ms, outlined_ms - stamped_ms, built_ms - outlined_ms,
            watch.worked_milliseconds() - built_ms};
  return !patch_.triangles.empty();
}

void OurCut::fill_buffers() {
  buffers_.positions_mm.clear();
  for (const Vec3& point_mm : patch_.points_in_bone_mm) {
    for (glm::length_t axis = 0; axis < 3; ++axis) {
      buffers_.positions_mm.push_back(static_cast<float>(point_mm[axis]));
    }
  }
  buffers_.indices.clear();
  for (const Triangle& corners : patch_.triangles) {
    buffers_.indices.insert(buffers_.indices.end(), corners.begin(), corners.end());
  }
  buffers_.hidden.assign(patch_.hidden.begin(), patch_.hidden.end());
}

RegionOutline whole_plane() {
  constexpr double reach_mm = 30.0;
  return {{Vec2(-reach_mm, -reach_mm), Vec2(reach_mm, -reach_mm), Vec2(reach_mm, reach_mm),
           Vec2(-reach_mm, reach_mm)},
          {4}};
}

}  // namespace hallux::benchmarks
