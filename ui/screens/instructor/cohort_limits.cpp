// The part of the cohort screen in which assessments are limited.
#include "ui/screens/instructor/cohort_screen.h"
#include "ui/screens/parts/desk_work.h"

namespace hallux::ui {

void CohortScreen::open_limits() {
  limits_.emplace();
  limits_->cohort_name = glance_.value().cohort.name;
  limits_->operations = glance_.value().operations;
  limits_->limits = glance_.value().limits;
  limiting_.forget_fault();
}

void CohortScreen::draw_limits(Ui& ui, Shell& shell) {
  if (!limits_) return;
  const Answer answer = draw_limits_dialog(ui, *limits_, limiting_.fault(), limiting_.is_running());
  if (answer == Answer::Keep) limits_.reset();
  if (answer != Answer::Act) return;
  const std::optional<LimitChange> change = change_in(*limits_);
  if (!change) return;
  limiting_.start<bool>(
      shell, visit_, {std::string(ui.text("limits.changing")), {}},
      [cohort = taught_[cohort_].cohort, change = *change](database::Session& session,
                                                           WorkReport&) {
        database::InstructorDesk desk = instructor_of(session, cohort);
        if (change.attempts_max) {
          desk.set_limit(change.scenario_name, *change.attempts_max);
        } else {
          desk.clear_limit(change.scenario_name);
        }
        return true;
      },
      [this, &shell, done = said_of(ui.texts(), *limits_, *change)](bool&) {
        limits_.reset();
        shell.say({Meaning::Good, done});
        glance_.read_again();
      });
}

}  // namespace hallux::ui
