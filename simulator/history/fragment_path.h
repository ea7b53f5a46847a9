/// The pose of a fragment over the time of a recording: where it was left, and where forceps led
/// it. Inside this corner only.
#pragma once

#include <cstdint>
#include <vector>

#include "simulator/base/transform.h"
#include "simulator/record/fragment_poses.h"

namespace hallux::simulator {

class FragmentPath {
 public:
  /// Both: ticks never fall; a later word for the same tick counts.
  /// Where it lies from this tick on, in the frame of its bone.
  void leave_at(std::int64_t tick, const QuantisedPose& bone_from_fragment) {
    add({tick, bone_from_fragment, false});
  }
  /// Where forceps hold it from this tick on, in the world.
  void lead_to(std::int64_t tick, const QuantisedPose& world_from_fragment) {
    add({tick, world_from_fragment, true});
  }

  /// Before the first word it lies where its bone has it.
  /// ensures what forceps held is to the bit what the sample says, what lies is as FragmentPoses
  RigidTransform world_from_fragment(std::int64_t tick,
                                     const RigidTransform& world_from_bone) const noexcept;
  /// Another where the pose may be another.
  std::size_t step_at(std::int64_t tick) const noexcept;
  /// Where it was left last, in the frame of its bone.
  QuantisedPose left_last() const noexcept;

 private:
  struct Step {
    std::int64_t tick = 0;
    QuantisedPose pose;
    bool is_in_world = false;
  };

  void add(const Step& step);

  /// By time.
  std::vector<Step> steps_;
};

/// One for each fragment of a recording, those of its bones first; and where each comes from.
struct FragmentPaths {
  struct Origin {
    std::int32_t bone = 0;
    /// The number that all of it has as a piece; -1: none, as up to engine 7 the half of a hinge.
    std::int32_t piece = 0;
    /// -1: none.
    std::int32_t parent = -1;
    std::int64_t from_tick = 0;
  };
  std::vector<Origin> origins;
  std::vector<FragmentPath> paths;
};

/// Events of fragments alone, as engine 8 would have said them: up to engine 7 the half that turned
/// at a hinge was no fragment, and here it is one, of a piece without a number (-1).
std::vector<CutEvent> fragment_events(const Recording& recording);

/// events  of fragment_events
/// lying   the bones' fragments before anything is moved
/// ensures what names a fragment that there is not is passed over, as by FragmentPoses
FragmentPaths fragment_paths(const std::vector<CutEvent>& events,
                             const std::vector<ToolSample>& samples, const FragmentPoses& lying);

}  // namespace hallux::simulator
