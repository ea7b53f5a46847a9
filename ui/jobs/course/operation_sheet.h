/// The parts of a scenario's sheet that only format 2 has. Inside this corner only.
#pragma once

#include <ostream>

#include "scenarios/scenario.h"

namespace hallux::ui {

/// All of them write nothing where the scenario has none.
void write_further_means(std::ostream& out, const scenarios::Scenario& scenario);
void write_places(std::ostream& out, const scenarios::Scenario& scenario);
void write_fixation(std::ostream& out, const scenarios::Scenario& scenario);

/// " after a, b; one of way; optional": what a step says of its order.
std::string order_text(const scenarios::OperationStep& step);

}  // namespace hallux::ui
