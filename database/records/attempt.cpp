#include "database/records/attempt.h"

namespace hallux::database {

bool is_grade(const AttemptHeader& header) noexcept {
  const bool is_a_persons =
      header.begun.person && header.begun.hand.empty() && !header.is_simulated && header.is_counted;
  const bool is_whole =
      header.state == AttemptState::Closed && header.is_complete && header.is_valid.value_or(false);
  const bool is_stood_for = header.decided_milli && header.decision_is_of_score_in_force &&
                            (header.decision == DecisionKind::Overridden || !header.is_partial);
  return is_a_persons && is_whole && is_stood_for && header.begun.kind == AttemptKind::Assessment;
}

}  // namespace hallux::database
