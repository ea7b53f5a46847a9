/// Where a hand aims: each planned face with the errors of the hand, and the section that its blade
/// will meet. Inside this corner only.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "scenarios/hands/hand_skill.h"
#include "scenarios/plan.h"
#include "simulator/cutting/slice/section.h"

namespace hallux::scenarios {

/// The bone as a hand knows it before it starts. Borrows the bone.
struct KnownBone {
  explicit KnownBone(const simulator::Bone& known);

  const simulator::Bone& bone;
  simulator::CutSolid solid;
  simulator::Bvh bvh;
};

/// All of a patient's.
struct KnownBones : std::deque<KnownBone> {
  explicit KnownBones(const simulator::Bones& bones) {
    for (const simulator::Bone& bone : bones) emplace_back(bone);
  }
};

struct AimedCut {
  /// The face it aims at.
  ReferenceFace face;
  /// From the plan; of a second cut to a hinge without a fault of its own, from where the planned
  /// wedge lies against the first face aimed at.
  double angle_error_rad = 0.0;
  /// Largest distance from the plan over the planned section.
  double location_error_mm = 0.0;
  /// Of the blade: x feed, y tooth line.
  simulator::KerfPlane plane;
  /// The bone in that plane.
  simulator::SectionRegion region;
  /// Feed at which it means to stop; none: through the bone.
  std::optional<double> stop_mm;
  /// By which it goes farther than it would, on purpose; below 0: by which it stops before.
  double run_on_mm = 0.0;
  /// It means to stop where no bone is left of the hinge.
  bool loses_hinge = false;
  /// Of the patient's bones, in whose frame all of this is said.
  std::size_t bone = 0;
};

/// One for each cut of the plan. A face through a hinge is measured off from the first face that
/// the hand aimed at.
/// A plane that misses the bone, or grazes it, is aimed anew, as by somebody who sees it.
/// errors  ScenarioError where the planned face misses the bone, or the approach is from no side
///         there is
std::vector<AimedCut> aim(const Scenario& scenario, const Plan& plan, const KnownBones& known,
                          const HandSkill& skill, std::uint64_t seed);

}  // namespace hallux::scenarios
