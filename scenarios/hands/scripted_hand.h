/// Scripted hands: a plan carried out with the errors of an expert or a novice, drawn from a seed.
///
/// A hand aims its blade at a face that is tilted and shifted against the plan, saws in overlapping strokes from the
/// approach side with a force it means to keep, wanders out of the plane while it pushes, and declares each step done.
/// The motion is fixed before it starts, timed by the feed law: it feels nothing. The sizes of the errors are the working expectation for freehand cuts in small bones:
/// expert 2 to 3 (SD 1.5) degrees and 0.8 (0.5) mm, novice 9 (5) degrees and 3 (1.5) mm; not measured on people.
#pragma once

#include <cstdint>
#include <string_view>

#include "scenarios/hands/stroke_timing.h"
#include "scenarios/plan.h"
#include "simulator/device/scripted.h"

namespace hallux::scenarios {

struct HandSkill {
  double angle_mean_deg = 2.5, angle_deviation_deg = 1.5;  ///< between the aimed face and the plan
  double location_mean_mm = 0.8,
         location_deviation_mm = 0.5;  ///< largest distance between them over the section
  double wander_mm = 0.3;              ///< out of the plane while sawing
  double wander_rad = 0.01;
  double stroke_jitter_mm = 0.1;  ///< out of the plane from stroke to stroke
  double stroke_jitter_rad = 0.005;
  double approach_mm_s = 30.0;
  Push push;  ///< the force it means to keep
};

/// errors  ScenarioError naming the hands there are
HandSkill hand_skill(std::string_view name);

struct ScriptedHand {
  simulator::HandMotion motion;
  ReferenceFace aimed;  ///< the face it aims at
  double angle_error_rad = 0.0;
  double location_error_mm = 0.0;
};

/// The hand for the scenario's first cut.
/// ensures the same arguments give the same motion on every machine
/// errors  ScenarioError where the aimed plane misses the bone
ScriptedHand make_hand(const Scenario& scenario, const simulator::Bone& bone, const Plan& plan,
                       const HandSkill& skill, std::uint64_t seed);

/// A motion from a JSON text: {"keys": [{"time_s", "tip_mm", "direction", "normal", "saw"}...]}, in the world frame.
/// errors  ScenarioError with `name`, the path and the mend
simulator::HandMotion parse_hand_motion(std::string_view json, std::string_view name);

}  // namespace hallux::scenarios
