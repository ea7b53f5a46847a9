#include "ui/screens/parts/desk_work.h"

namespace hallux::ui {

database::AdministratorDesk administrator_of(database::Session& session) {
  return desk_or_refused(session.administrator(),
                         "you are no administrator of this course any more; ask one who is");
}

database::InstructorDesk instructor_of(database::Session& session, database::CohortId cohort) {
  return desk_or_refused(
      session.instructor_of(cohort),
      "you do not teach this cohort any more; ask an administrator of the course");
}

database::TraineeDesk trainee_of(database::Session& session) {
  return desk_or_refused(session.trainee(),
                         "you were disabled; ask an administrator of the course");
}

void DeskWork::change(Shell& shell, std::shared_ptr<SignedInSession> signed_in, WorkTexts words,
                      std::function<void(database::Session&)> act, std::function<void()> done) {
  start<bool>(
      shell, std::move(signed_in), std::move(words),
      [act = std::move(act)](database::Session& session, WorkReport&) {
        act(session);
        return true;
      },
      [done = std::move(done)](bool&) { done(); });
}

void DeskWork::change_course(const Ui& ui, Shell& shell, std::shared_ptr<SignedInSession> signed_in,
                             CourseChange wanted) {
  const std::string_view failed = wanted.is_fault_shown ? "" : ui.text("people.not_changed");
  change(
      shell, std::move(signed_in), {std::string(ui.text("people.changing")), std::string(failed)},
      [act = std::move(wanted.act)](database::Session& session) {
        database::AdministratorDesk desk = administrator_of(session);
        act(desk);
      },
      [&shell, done = std::move(wanted.done), after = std::move(wanted.after)] {
        after();
        shell.say({Meaning::Good, done});
      });
}

void DeskWork::say_failed(Shell& shell, const WorkTexts& words, const std::string& reason) {
  fault_ = sentence_of(reason);
  if (!words.failed.empty()) shell.say({Meaning::Bad, words.failed, fault_});
}

}  // namespace hallux::ui
