/// Fragments of an attempt and where they lie, by its events: one rule for the step, its jobs and
/// for scoring.
///
///     bone 0, bone 1 ...     fragments 0, 1 ..., where the patient has them
///     FragmentParted         the next fragment: a piece of another one, still where it was
///     HingeClosed, Released  the fragment lies elsewhere from now on
///
/// A fragment moves as one. Everything about it is said in its own frame, which is that of the bone
/// it comes from, as it was before anything moved.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "simulator/base/transform.h"
#include "simulator/record/record.h"

namespace hallux::simulator {

/// Bones that an operation may be about, and pieces of them that may move.
inline constexpr std::int32_t bone_limit = 4, moved_fragment_limit = 8;
inline constexpr std::int32_t fragment_limit = bone_limit + moved_fragment_limit;

struct FragmentPose {
  /// Whose frame it has.
  std::int32_t bone = 0;
  /// That it was a part of; -1: none.
  std::int32_t parent = -1;
  RigidTransform bone_from_fragment;
  RigidTransform world_from_fragment, fragment_from_world;
  bool is_moved = false;
};

class FragmentPoses {
 public:
  /// One fragment a bone.
  /// needs   one to bone_limit of them
  explicit FragmentPoses(std::span<const RigidTransform> world_from_bones) noexcept;
  /// Of one bone.
  explicit FragmentPoses(const RigidTransform& world_from_bone) noexcept
      : FragmentPoses(std::span(&world_from_bone, 1)) {}

  std::int32_t bone_count() const noexcept { return bone_count_; }
  std::int32_t count() const noexcept { return count_; }
  bool is_full() const noexcept { return count_ == bone_count_ + moved_fragment_limit; }
  const FragmentPose& operator[](std::int32_t fragment) const noexcept {
    return poses_[static_cast<std::size_t>(fragment)];
  }

  /// ensures events that part or place no fragment change nothing
  /// errors  false where the event names a fragment that there is not, or one more than there may
  ///         be; nothing changed then
  /// thread  haptic; allocates nothing
  bool apply(const CutEvent& event) noexcept;

 private:
  void place(std::int32_t fragment, const RigidTransform& bone_from_fragment) noexcept;
  bool part(std::int32_t parent) noexcept;

  std::array<FragmentPose, static_cast<std::size_t>(fragment_limit)> poses_{};
  std::array<RigidTransform, static_cast<std::size_t>(bone_limit)> world_from_bones_{};
  std::int32_t bone_count_ = 0, count_ = 0;
};

}  // namespace hallux::simulator
