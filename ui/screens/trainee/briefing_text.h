/// The words of a briefing: what a scenario says of itself, laid out to be read. Each returns the
/// height that it took. Inside this corner only.
#pragma once

#include <span>

#include "scenarios/scenario.h"
#include "ui/screens/pictures/planned_passes_picture.h"
#include "ui/widgets/ui.h"

namespace hallux::ui {

/// Indication, what is done, what must stay whole.
/// passes  of the blade, by cut of the scenario; empty until the patient is there
float draw_about(Ui& ui, const Rect& rect, const scenarios::Scenario& scenario,
                 std::span<const PassesInView> passes);
/// The steps in their order, with a picture of the passes where a cut needs several; what Done
/// means.
float draw_steps(Ui& ui, const Rect& rect, const scenarios::Scenario& scenario,
                 std::span<const PassesInView> passes);
/// What lies on the tray, what is shifted, and what is fixed with what.
/// needs   has_tray(scenario)
float draw_tray(Ui& ui, const Rect& rect, const scenarios::Scenario& scenario);
/// What is scored with its weights, and what caps the score.
float draw_scoring(Ui& ui, const Rect& rect, const scenarios::Scenario& scenario);

}  // namespace hallux::ui
