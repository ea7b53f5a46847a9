/// What a card's sentences are made from: what stands in the scenario and in the measurements and
/// not in the card's numbers. With it a card tells itself, whatever becomes of the rubric.
/// Inside this corner only.
#pragma once

#include <span>

#include "assessment/measurement.h"
#include "database/records/score.h"
#include "scenarios/scenario.h"

namespace hallux::assessment {

/// Fills the facts of ledger lines and gates, and the messages: the greatest losses first, those of
/// gates and of safety sooner, three at most.
/// needs   the card was balanced from this scenario's rubric and these measurements
void add_facts(database::ScoreCard& card, const scenarios::Scenario& scenario,
               std::span<const Measurement> measurements);

}  // namespace hallux::assessment
