/// How well a scripted hand does what it means to do: the sizes of its errors, how it pushes, and
/// what it notices when.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "scenarios/hands/hand_fault.h"

namespace hallux::scenarios {

/// The force that a hand means to keep along the feed.
struct Push {
  double steady_newton = 15.0;
  /// In the last millimetres before the far surface.
  double exit_newton = 8.0;
  double exit_mm = 1.5;
  /// Of teeth that it sees in bone: a corner is not forced.
  double most_newton_per_mm = 1.3;
  /// On top of all that, on purpose.
  double extra_newton = 0.0;
  /// Deviation of the push from what it means, as a share.
  double unevenness = 0.05;
  /// By which it pushes harder where it sees no progress.
  double impatience_newton_per_s = 0.0;
  /// How the arm gives where nothing holds against the push: speed = missing newtons / brace, at
  /// most the lean.
  double brace_newton_s_per_mm = 0.3;
  double lean_mm_s = 10.0;
};

/// What a hand notices, and when.
struct Perception {
  /// From what is felt or seen to what the hand does about it.
  double reaction_s = 0.18;
  /// Deviation of the depth that it sees.
  double eye_mm = 0.1;
  /// By which it knows its depth less the longer it has not looked.
  double doubt_mm_per_s = 0.02;
  /// How long it hesitates to look, the saw running.
  double look_s = 0.4;
  /// How fast it undoes what it notices of its wander.
  double steadying_per_s = 1.5;
};

/// How a hand keeps bone cool.
struct Cooling {
  bool has_water = true;
  /// How often it saws without, 0 to 1.
  double forgets_water = 0.0;
  /// Mean time until it notices that.
  double notices_dry_s = 2.0;
  /// It saws so long, then draws the blade back to clear the kerf.
  double burst_s = 5.0;
  /// By so much.
  double clear_mm = 3.0;
};

/// Means and deviations of normal numbers; the defaults are the expert's. source  docs/hands.md
struct HandSkill {
  /// Between the aimed face and the plan.
  double angle_mean_deg = 2.5, angle_deviation_deg = 1.5;
  /// Largest distance between them over the section.
  double location_mean_mm = 0.8, location_deviation_mm = 0.5;
  /// No hand errs less than this by luck.
  double least_angle_deg = 0.3, least_location_mm = 0.05;
  /// Out of the plane while sawing, before it is noticed.
  double wander_mm = 0.3;
  double wander_rad = 0.01;
  /// Out of the plane from stroke to stroke.
  double stroke_jitter_mm = 0.1;
  double stroke_jitter_rad = 0.005;
  /// How far the outermost strokes reach beyond the bone's sides.
  double edge_margin_mm = 0.15;
  /// How far it goes on after the last bone that it expects.
  double beyond_mm = 1.5;
  double approach_mm_s = 30.0;
  Push push;
  Perception perception;
  Cooling cooling;
  /// Where a cut is to stop inside the bone: how far beyond the planned line it stops.
  double stop_mean_mm = -0.4, stop_deviation_mm = 0.3;
  /// How well a second cut comes to the end of the first.
  double meet_deviation_mm = 0.2;
  /// Of a fragment that it leads: along the planned way, and about the foot's dorsal.
  double shift_deviation_mm = 0.5, shift_turn_deviation_deg = 1.0;
  /// A second cut and its end are those of the plan, not measured off from the first cut.
  bool keeps_to_plan = false;
  /// What it does wrong on purpose.
  std::vector<HandFault> faults = {};
};

inline constexpr std::array<std::string_view, 3> hand_names{"expert", "novice", "perfect"};
bool is_hand_name(std::string_view name) noexcept;
/// errors  ScenarioError naming the hands there are
HandSkill hand_skill(std::string_view name);
/// The skill that does these wrong as well.
HandSkill with_faults(HandSkill skill, std::vector<HandFault> faults);

}  // namespace hallux::scenarios
