#include "ui/screens/standing.h"

#include "ui/screens/course_words.h"

namespace hallux::ui {

Competence competence_of(const database::OperationStanding& standing, std::string_view now_utc) {
  if (standing.attempts == 0) return Competence::NotStarted;
  if (days_between(standing.last_started_utc, now_utc) > long_ago_days) return Competence::Stale;
  const bool has_slipped = standing.best_milli && standing.last_milli &&
                           *standing.best_milli - *standing.last_milli >= slipped_by_milli;
  return has_slipped ? Competence::Slipped : Competence::Learning;
}

float progress_of(const database::OperationStanding& standing) noexcept {
  return static_cast<float>(standing.best_milli.value_or(0)) * 1e-5F;
}

}  // namespace hallux::ui
