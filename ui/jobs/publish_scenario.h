/// What a scenario has to pass before trainees may choose it.
#pragma once

#include "scenarios/scenario.h"
#include "simulator/base/progress.h"

namespace hallux::ui {

/// Proves the scenario's rubric: the perfect hand, without and with each fault that it lists (see
/// prove_scenario.h).
/// errors  ScenarioError saying what came out otherwise, and how to see all of it; Cancelled
/// thread  work's; some seconds for each performance
void prove_to_publish(const scenarios::Scenario& scenario, const Progress& progress);

}  // namespace hallux::ui
