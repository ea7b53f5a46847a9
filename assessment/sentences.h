/// One plain sentence with numbers for each line of a ledger, and the three that matter most. Their
/// points are those that are shown, of 100 (see shown_points.h). Inside this corner only.
#pragma once

#include <span>

#include "assessment/measurement.h"
#include "database/records/score.h"
#include "scenarios/scenario.h"

namespace hallux::assessment {

/// Fills the texts of ledger lines and gates, and the sentences: the greatest losses first, those
/// of gates and of safety sooner, three at most.
/// needs   the card was balanced from this scenario's rubric and these measurements
void explain(database::ScoreCard& card, const scenarios::Scenario& scenario,
             std::span<const Measurement> measurements);

}  // namespace hallux::assessment
