#include "simulator/step/standing_fragments.h"

#include <algorithm>
#include <cmath>

namespace hallux::simulator {

StandingFragments::StandingFragments(std::span<const TissueMap* const> tissues,
                                     std::span<const Bone* const> bones,
                                     const KerfSet& kerfs) noexcept
    : kerfs_(kerfs), wound_from_world_(inverse(bones.front()->world_from_bone)), wound_(kerfs) {
  for (std::size_t bone = 0; bone < bones.size(); ++bone) {
    bones_[bone] = standing(*tissues[bone], *bones[bone]);
    stand(static_cast<std::int32_t>(bone), {});
  }
}

StandingFragments::StandingBone StandingFragments::standing(const TissueMap& tissue,
                                                            const Bone& bone) noexcept {
  StandingBone standing{&tissue};
  for (const Vec3& point : bone.outer.points_mm) standing.centre_mm += point;
  standing.centre_mm /= static_cast<double>(bone.outer.points_mm.size());
  for (const Vec3& point : bone.outer.points_mm)
    standing.radius_mm = std::max(standing.radius_mm, length_of(point - standing.centre_mm));
  return standing;
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
  const StandingBone& bone = bones_[static_cast<std::size_t>(pose.bone)];
  const RemainingTissue tissue{*bone.tissue, FragmentKerfs(kerfs_, fragment), removed,
                               surfaces_[static_cast<std::size_t>(fragment)]};
  const bool is_elsewhere = pose.is_moved || pose.bone != 0;
  WoundFragment standing{tissue, {}, {}, is_elsewhere, bone.centre_mm, bone.radius_mm};
  if (is_elsewhere) {
    standing.wound_from_fragment = wound_from_world_ * pose.world_from_fragment;
    standing.fragment_from_wound = inverse(standing.wound_from_fragment);
  }
  wound_.put(fragment, standing);
}

}  // namespace hallux::simulator
