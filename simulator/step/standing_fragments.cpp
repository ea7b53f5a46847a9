#include "simulator/step/standing_fragments.h"

#include <algorithm>
#include <cmath>

namespace hallux::simulator {

StandingFragments::StandingFragments(const TissueMap& tissue, const Bone& bone,
                                     const KerfSet& kerfs) noexcept
    : tissue_(tissue),
      kerfs_(kerfs),
      wound_from_world_(inverse(bone.world_from_bone)),
      wound_(kerfs) {
  for (const Vec3& point : bone.outer.points_mm) centre_mm_ += point;
  centre_mm_ /= static_cast<double>(bone.outer.points_mm.size());
  for (const Vec3& point : bone.outer.points_mm)
    radius_mm_ = std::max(radius_mm_, length_of(point - centre_mm_));
  stand(0, {});
}

std::optional<WoundJoint> StandingFragments::joint_of(std::int32_t fragment) const noexcept {
  const std::optional<WoundJoint>& joint = joints_[static_cast<std::size_t>(fragment)];
  if (!joint) return std::nullopt;
  const std::int32_t parent = kerfs_.fragments()[fragment].parent;
  const WoundFragment* const standing = wound_.fragment(parent);
  if (standing == nullptr) return std::nullopt;
  return WoundJoint{transform_point(standing->wound_from_fragment, joint->point_mm),
                    transform_direction(standing->wound_from_fragment, joint->axis),
                    joint->free_radius_mm};
}

void StandingFragments::stand(std::int32_t fragment, std::span<const Bvh* const> removed) noexcept {
  const FragmentPose& pose = kerfs_.fragments()[fragment];
  const RemainingTissue tissue{tissue_, FragmentKerfs(kerfs_, fragment), removed,
                               surfaces_[static_cast<std::size_t>(fragment)]};
  WoundFragment standing{tissue, {}, {}, pose.is_moved, centre_mm_, radius_mm_};
  if (pose.is_moved) {
    standing.wound_from_fragment = wound_from_world_ * pose.world_from_fragment;
    standing.fragment_from_wound = inverse(standing.wound_from_fragment);
  }
  wound_.put(fragment, standing);
}

}  // namespace hallux::simulator
