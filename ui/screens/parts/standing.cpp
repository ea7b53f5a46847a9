#include "ui/screens/parts/standing.h"

#include "ui/screens/parts/course_text.h"
#include "ui/times/local_time.h"

namespace hallux::ui {

Competence competence_of(const database::OperationStanding& standing,
                         const assessment::LearningState& learning, std::string_view now_utc) {
  if (learning.is_competent) return Competence::Competent;
  if (learning.has_slipped) return Competence::Slipped;
  if (standing.attempts == 0) return Competence::NotStarted;
  if (days_between(standing.last_started_utc, now_utc) > long_ago_days) return Competence::Stale;
  const bool is_far_below = standing.best_milli && standing.last_milli &&
                            *standing.best_milli - *standing.last_milli >= slipped_by_milli;
  return is_far_below ? Competence::Slipped : Competence::Learning;
}

float progress_of(const database::OperationStanding& standing,
                  const assessment::LearningState& learning) noexcept {
  return learning.evidence_by_run.empty()
             ? static_cast<float>(standing.best_milli.value_or(0)) * 1e-5F
             : static_cast<float>(learning.evidence / assessment::evidence_needed);
}

}  // namespace hallux::ui
