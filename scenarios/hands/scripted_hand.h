/// Scripted hands: a plan carried out with the errors of an expert or a novice, drawn from a seed.
///
/// A hand aims its blade at faces that are tilted and shifted against the plan, saws in overlapping strokes from the
/// approach side with a force it means to keep, stops at a hinge as well as it can, wanders out of the plane while it
/// pushes, and declares each step done. The motion is fixed before it starts, timed by the feed law: it feels nothing.
/// The sizes of the errors are the working expectation for freehand cuts in small bones; not measured on people.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "scenarios/hands/hand_aim.h"
#include "simulator/device/scripted.h"

namespace hallux::scenarios {

struct ScriptedHand {
  simulator::HandMotion motion;
  std::vector<AimedCut> cuts;  ///< as the plan has them
};

/// The hand for all of the scenario's steps.
/// ensures the same arguments give the same motion on every machine
/// errors  ScenarioError where an aimed plane misses the bone
ScriptedHand make_hand(const Scenario& scenario, const simulator::Bone& bone, const Plan& plan,
                       const HandSkill& skill, std::uint64_t seed);

/// A motion from a JSON text: {"keys": [{"time_s", "tip_mm", "direction", "normal", "saw"}...]}, in the world frame.
/// errors  ScenarioError with `name`, the path and the mend
simulator::HandMotion parse_hand_motion(std::string_view json, std::string_view name);

}  // namespace hallux::scenarios
