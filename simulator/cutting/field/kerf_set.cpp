#include "simulator/cutting/field/kerf_set.h"

#include <cmath>

namespace hallux::simulator {

KerfSet::KerfSet(const Blade& blade, const RigidTransform& world_from_bone, const FieldGrid& grid)
    : blade_(blade),
      bone_from_world_(inverse(world_from_bone)),
      planes_(static_cast<std::size_t>(kerf_limit)),
      kerf_from_bone_(static_cast<std::size_t>(kerf_limit)),
      pool_(std::make_unique<TilePool>(
          static_cast<std::size_t>(kerf_limit) * KerfField::tiles_of(grid),
          KerfField::closed_mm(grid))) {
  fields_.reserve(static_cast<std::size_t>(kerf_limit));
  for (std::int32_t kerf = 0; kerf < kerf_limit; ++kerf) fields_.emplace_back(grid, *pool_);
}

std::int32_t KerfSet::freeze(const QuantisedPose& bone_from_tool) noexcept {
  if (count_ == kerf_limit) return -1;
  planes_[index(count_)] = {transform_from(bone_from_tool), blade_.kerf_mm};
  kerf_from_bone_[index(count_)] = inverse(planes_[index(count_)].bone_from_kerf);
  return count_++;
}

FieldWindow KerfSet::apply(const ToolSample& sample) noexcept {
  FieldWindow changed;
  const bool cuts =
      sample.kerf >= 0 && sample.kerf < count_ && has(sample.status, ToolStatus::SawOn);
  if (!cuts) {
    last_kerf_ = -1;
    return changed;
  }
  const KerfPlane& kerf_plane = planes_[index(sample.kerf)];
  const PlanarPose pose =
      planar_pose(kerf_plane, bone_from_world_ * transform_from(sample.world_from_tool));
  const PlanarPose from = last_kerf_ == sample.kerf ? last_pose_ : pose;
  fields_[index(sample.kerf)].stamp(blade_, from, pose, changed);
  last_kerf_ = sample.kerf;
  last_pose_ = pose;
  return changed;
}

bool KerfSet::is_open(const Vec3& point_in_bone_mm) const noexcept {
  for (std::int32_t kerf = 0; kerf < count_; ++kerf) {
    const Vec3 local = transform_point(kerf_from_bone_[index(kerf)], point_in_bone_mm);
    const bool in_slab = std::abs(local.z) <= 0.5 * planes_[index(kerf)].thickness_mm;
    if (in_slab && fields_[index(kerf)].is_open(Vec2{local.x, local.y})) return true;
  }
  return false;
}

}  // namespace hallux::simulator
