#include "scenarios/hands/hand_skill.h"

#include <algorithm>
#include <string>
#include <utility>

#include "scenarios/scenario_error.h"

namespace hallux::scenarios {

namespace {

HandSkill novice_hand() {
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
  novice.cooling = {.forgets_water = 0.8, .notices_dry_s = 15.0, .burst_s = 20.0, .clear_mm = 3.0};
  novice.stop_mean_mm = 0.0;
  novice.stop_deviation_mm = 1.5;
  novice.meet_deviation_mm = 0.6;
  novice.shift_deviation_mm = 2.0;
  novice.shift_turn_deviation_deg = 4.0;
  return novice;
}

/// The expert's pushes, water and care, without an error. A push that is nearly let go stretches
/// the hold on the saw by little, and what is noticed at once is not leant on: so bone that gives
/// way lets the teeth run on by little. It reaches as far beyond the sides as it takes to saw them
/// wholly.
HandSkill perfect_hand() {
  HandSkill perfect;
  perfect.angle_mean_deg = perfect.angle_deviation_deg = perfect.least_angle_deg = 0.0;
  perfect.location_mean_mm = perfect.location_deviation_mm = perfect.least_location_mm = 0.0;
  perfect.wander_mm = perfect.wander_rad = 0.0;
  perfect.stroke_jitter_mm = perfect.stroke_jitter_rad = 0.0;
  perfect.edge_margin_mm = 0.3;
  perfect.beyond_mm = 0.2;
  perfect.push.exit_newton = 3.0;
  perfect.push.unevenness = 0.0;
  perfect.perception.reaction_s = 0.0;
  perfect.perception.eye_mm = perfect.perception.doubt_mm_per_s = 0.0;
  perfect.stop_mean_mm = perfect.stop_deviation_mm = perfect.meet_deviation_mm = 0.0;
  perfect.shift_deviation_mm = perfect.shift_turn_deviation_deg = 0.0;
  perfect.keeps_to_plan = true;
  return perfect;
}

}  // namespace

bool is_hand_name(std::string_view name) noexcept {
  return std::find(hand_names.begin(), hand_names.end(), name) != hand_names.end();
}

HandSkill hand_skill(std::string_view name) {
  if (name == "expert") return {};
  if (name == "novice") return novice_hand();
  if (name == "perfect") return perfect_hand();
  throw ScenarioError("there is no hand \"" + std::string(name) +
                      "\"; use expert, novice, perfect, or a file with a motion");
}

HandSkill with_faults(HandSkill skill, std::vector<HandFault> faults) {
  skill.push.extra_newton = fault_size(faults, FaultKind::Press);
  skill.cooling.has_water = !has_fault(faults, FaultKind::Dry);
  skill.faults = std::move(faults);
  return skill;
}

}  // namespace hallux::scenarios
