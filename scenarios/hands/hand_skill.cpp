#include "scenarios/hands/hand_skill.h"

#include <string>

#include "scenarios/scenario_error.h"

namespace hallux::scenarios {

HandSkill hand_skill(std::string_view name) {
  if (name == "expert") return {};
  if (name == "novice") {
    HandSkill novice;
    novice.angle_mean_deg = 9.0;
    novice.angle_deviation_deg = 5.0;
    novice.location_mean_mm = 3.0;
    novice.location_deviation_mm = 1.5;
    novice.wander_mm = 4.0;
    novice.wander_rad = 0.06;
    novice.stroke_jitter_mm = 0.25;
    novice.stroke_jitter_rad = 0.015;
    novice.approach_mm_s = 60.0;
    novice.push = {26.0, 26.0, 2.5};
    novice.stop_mean_mm = 0.0;
    novice.stop_deviation_mm = 1.5;
    novice.meet_deviation_mm = 0.6;
    novice.looks = 1;
    return novice;
  }
  throw ScenarioError("there is no hand \"" + std::string(name) +
                      "\"; use expert, novice, or a file with a motion");
}

}  // namespace hallux::scenarios
