#include "database/records/score.h"

#include <algorithm>

namespace hallux::database {

PassFacts pass_facts_of(const ScoreCard& card) noexcept {
  PassFacts facts;
  facts.measured_milli = card.measured_milli;
  facts.rubric_milli = card.rubric_milli;
  for (const GroupScore& group : card.groups) {
    if (group.name != "safety") continue;
    facts.safety_measured_milli += group.measured_milli;
    facts.safety_earned_milli += group.earned_milli;
  }
  facts.is_gated = std::any_of(card.gates.begin(), card.gates.end(),
                               [](const GateResult& gate) { return gate.is_triggered; });
  return facts;
}

}  // namespace hallux::database
