#include "simulator/record/fragment_poses.h"

#include "simulator/base/check.h"

namespace hallux::simulator {

FragmentPoses::FragmentPoses(std::span<const RigidTransform> world_from_bones) noexcept {
  CHECK(!world_from_bones.empty() &&
        world_from_bones.size() <= static_cast<std::size_t>(bone_limit));
  for (const RigidTransform& world_from_bone : world_from_bones) {
    const auto bone = static_cast<std::size_t>(count_);
    world_from_bones_[bone] = world_from_bone;
    poses_[bone] = {count_, -1, RigidTransform{}, world_from_bone, inverse(world_from_bone), false};
    ++count_;
  }
  bone_count_ = count_;
}

bool FragmentPoses::apply(const CutEvent& event) noexcept {
  switch (event.kind) {
    case CutEventKind::FragmentParted:
      return part(static_cast<std::int32_t>(event.value));
    case CutEventKind::HingeClosed:
      // Up to engine 7 the half that turned was no fragment.
      if (count_ > bone_count_) place(count_ - 1, transform_from(event.pose));
      return true;
    case CutEventKind::Released:
      if (event.subject < 0 || event.subject >= count_) return false;
      place(event.subject, transform_from(event.pose));
      return true;
    default:
      return true;
  }
}

bool FragmentPoses::part(std::int32_t parent) noexcept {
  if (parent < 0 || parent >= count_ || is_full()) return false;
  FragmentPose& parted = poses_[static_cast<std::size_t>(count_++)];
  parted = (*this)[parent];
  parted.parent = parent;
  return true;
}

void FragmentPoses::place(std::int32_t fragment,
                          const RigidTransform& bone_from_fragment) noexcept {
  FragmentPose& pose = poses_[static_cast<std::size_t>(fragment)];
  pose.bone_from_fragment = bone_from_fragment;
  pose.world_from_fragment =
      world_from_bones_[static_cast<std::size_t>(pose.bone)] * bone_from_fragment;
  pose.fragment_from_world = inverse(pose.world_from_fragment);
  pose.is_moved = true;
}

}  // namespace hallux::simulator
