/// The panels over the picture of an operation: mode and time, steps, tool, force, how the blade
/// stands to the plan, health. Inside this corner only.
///
/// All of it lies within an inset of 6 %, and the middle stays free. What does not fit a small
/// window goes in this order: the reading of the plan, the tool, the titles of steps.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ui/screens/operating/operating_health.h"
#include "ui/screens/operating/plan_reading.h"
#include "ui/widgets/ui.h"

namespace hallux::ui {

/// Of the window, around everything that lies over the picture.
inline constexpr float hud_inset_share = 0.06F;

struct OperatingHud {
  bool is_practice = true, is_paused = false, is_reviewed = false, is_simulated = false;
  std::int64_t tick = 0;
  std::vector<std::string> steps;
  /// At which one is.
  std::size_t step = 0;
  /// What its button says; "" for none.
  std::string_view step_action;
  /// It was pressed, and its work is under way.
  bool is_step_busy = false;
  bool is_step_ready = true;
  simulator::Saw saw;
  bool is_saw_on = false, is_irrigated = false;
  double force_newton = 0.0;
  /// Of the hottest bone, where it is told while operating.
  std::optional<double> bone_celsius;
  /// Of the blade, on the window.
  std::optional<Point> tip;
  std::optional<PlanReading> reading;
  OperatingHealth health;
  bool is_health_open = false;
};

/// What was pressed.
struct HudAnswer {
  bool step = false, pause = false, health = false, finish = false, abandon = false;
};

HudAnswer draw_operating_hud(Ui& ui, const OperatingHud& hud);

/// One decimal with the true minus: "−2.4".
std::string signed_text(double value);
/// One decimal.
std::string decimal_text(double value);

}  // namespace hallux::ui
