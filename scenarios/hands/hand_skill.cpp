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
    novice.edge_margin_mm = 1.5;
    novice.approach_mm_s = 60.0;
    novice.push = {.steady_newton = 20.0,
                   .exit_newton = 20.0,
                   .most_newton_per_mm = 20.0,
                   .unevenness = 0.25,
                   .impatience_newton_per_s = 1.0,
                   .lean_mm_s = 12.0};
    novice.perception = {.reaction_s = 0.35,
                         .eye_mm = 0.5,
                         .doubt_mm_per_s = 0.3,
                         .look_s = 0.9,
                         .steadying_per_s = 0.6};
    novice.cooling = {
        .forgets_water = 0.8, .notices_dry_s = 15.0, .burst_s = 20.0, .clear_mm = 3.0};
    novice.stop_mean_mm = 0.0;
    novice.stop_deviation_mm = 1.5;
    novice.meet_deviation_mm = 0.6;
    return novice;
  }
  throw ScenarioError("there is no hand \"" + std::string(name) +
                      "\"; use expert, novice, or a file with a motion");
}

}  // namespace hallux::scenarios
