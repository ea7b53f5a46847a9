#include "ui/screens/parts/desk_work.h"

namespace hallux::ui {

namespace {

template <typename Desk>
Desk held(std::optional<Desk> desk, const char* reason) {
  if (!desk) throw database::DatabaseError(database::DatabaseErrorKind::Refused, reason);
  return std::move(*desk);
}

}  // namespace

database::AdministratorDesk administrator_of(database::Session& session) {
  return held(session.administrator(),
              "you are no administrator of this course any more; ask one who is");
}

database::InstructorDesk instructor_of(database::Session& session, database::CohortId cohort) {
  return held(session.instructor_of(cohort),
              "you do not teach this cohort any more; ask an administrator of the course");
}

database::TraineeDesk trainee_of(database::Session& session) {
  return held(session.trainee(), "you were disabled; ask an administrator of the course");
}

void DeskWork::say_failed(Shell& shell, const DeskWords& words, const std::string& reason) {
  fault_ = sentence_of(reason);
  if (!words.failed.empty()) shell.say({Meaning::Bad, words.failed, fault_});
}

}  // namespace hallux::ui
