/// The start view of a scenario, looked at without a window: a view that hides its own cut is a
/// fault of the scenario.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "ui/sight/view_judge.h"

namespace hallux::ui {

struct StartViewCheck {
  /// Nothing where nothing could be drawn here.
  std::optional<ViewJudgement> judgement;
  /// The scenario says no start: judged is the view that it opens with then.
  bool is_default = false;
  /// Why nothing could be drawn; empty otherwise.
  std::string why_not_drawn;
};

/// Draws some twenty small pictures of ids in a context of its own.
/// file    the scenario's, for the message
/// bones   the scenario's patient, as coarse as one likes, with the plan on it
/// errors  ScenarioError where less than ViewLimits::least_share of tooth line or kerf is seen over
///         the plan's strokes: how much, what hides it, and the mend
/// thread  one without a current context
StartViewCheck check_start_view(const scenarios::Scenario& scenario, simulator::Bones bones,
                                const scenarios::Plan& plan, std::string_view file);

}  // namespace hallux::ui
