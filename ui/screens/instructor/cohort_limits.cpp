#include "ui/screens/instructor/cohort_limits.h"

namespace hallux::ui {

void CohortLimits::open(database::CohortId cohort, LimitsForm form) {
  cohort_ = cohort;
  form_ = std::move(form);
  work_.forget_fault();
}

void CohortLimits::draw(Ui& ui, Shell& shell, std::function<void()> changed) {
  if (!form_) return;
  const Answer answer = draw_limits_dialog(ui, *form_, work_.fault(), work_.is_running());
  if (answer == Answer::Keep) form_.reset();
  if (answer != Answer::Act) return;
  const std::optional<LimitChange> change = change_in(*form_);
  if (!change) return;
  work_.start<bool>(
      shell, signed_in_, {std::string(ui.text("limits.changing")), {}},
      [cohort = cohort_, change = *change](database::Session& session, WorkReport&) {
        database::InstructorDesk desk = instructor_of(session, cohort);
        if (change.attempts_max) {
          desk.set_limit(change.scenario_name, *change.attempts_max);
        } else {
          desk.clear_limit(change.scenario_name);
        }
        return true;
      },
      [this, &shell, changed = std::move(changed),
       done = said_of(ui.texts(), *form_, *change)](bool&) {
        form_.reset();
        shell.say({Meaning::Good, done});
        changed();
      });
}

}  // namespace hallux::ui
