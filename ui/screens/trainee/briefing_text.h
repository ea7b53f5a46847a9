/// The words of a briefing: what a scenario says of itself, laid out to be read. Each returns the
/// height that it took. Inside this corner only.
#pragma once

#include "scenarios/scenario.h"
#include "ui/widgets/ui.h"

namespace hallux::ui {

/// Indication, what is done, what must stay whole.
float draw_about(Ui& ui, const Rect& rect, const scenarios::Scenario& scenario);
/// The steps in their order.
float draw_steps(Ui& ui, const Rect& rect, const scenarios::Scenario& scenario);
/// What is scored with its weights, and what caps the score.
float draw_scoring(Ui& ui, const Rect& rect, const scenarios::Scenario& scenario);

}  // namespace hallux::ui
