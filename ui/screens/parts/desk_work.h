/// What a person does at a desk: it runs beside the window, and how it ended is said.
///
///     DeskWork work_;
///     work_.start<IssuedCode>(
///         shell, visit_, {label, failed},
///         [login](database::Session& session, WorkReport&) {
///           return administrator_of(session).reset(login);
///         },
///         [this](IssuedCode& issued) { show(std::move(issued)); });
///
/// Where it fails nothing of the screen changes: what was typed stays, and the sentence of the
/// fault is said.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "ui/screens/parts/screen_work.h"
#include "ui/screens/parts/signed_in_session.h"
#include "ui/screens/parts/value_text.h"

namespace hallux::ui {

/// errors  DatabaseError Refused with this reason where there is no such desk for the person
template <typename Desk>
Desk desk_or_refused(std::optional<Desk> desk, const char* reason) {
  if (!desk) throw database::DatabaseError(database::DatabaseErrorKind::Refused, reason);
  return std::move(*desk);
}

/// errors  DatabaseError Refused where the person is no administrator any more
database::AdministratorDesk administrator_of(database::Session& session);
/// errors  DatabaseError Refused where the person does not teach that cohort any more
database::InstructorDesk instructor_of(database::Session& session, database::CohortId cohort);
/// errors  DatabaseError Refused where the person was disabled since
database::TraineeDesk trainee_of(database::Session& session);

struct WorkTexts {
  /// While it runs.
  std::string label;
  /// The head of the message where it fails; "": the screen shows fault() itself.
  std::string failed;
  /// Said where the person stopped it; "": nothing.
  std::string stopped = {};
};

/// What an administrator changes in the course.
struct CourseChange {
  /// Holds nothing of the screen's.
  std::function<void(database::AdministratorDesk&)> act;
  /// Said once it was made, and what happens before that.
  std::string done;
  std::function<void()> after;
  /// The screen shows fault() itself; else a message says it.
  bool is_fault_shown = false;
};

class DeskWork {
 public:
  /// `act` holds nothing of the screen's. `done` is called in a frame while the screen is there.
  /// thread  the window's
  template <typename Result>
  void start(Shell& shell, std::shared_ptr<SignedInSession> signed_in, WorkTexts words,
             std::function<Result(database::Session&, WorkReport&)> act,
             std::function<void(Result&)> done) {
    fault_.clear();
    auto result = std::make_shared<std::optional<Result>>();
    std::string label = words.label;
    work_.start(
        shell, std::move(label),
        [result, signed_in = std::move(signed_in), act = std::move(act)](WorkReport& report) {
          signed_in->in_turn([&](database::Session& session, database::Database&) {
            result->emplace(act(session, report));
          });
        },
        [this, &shell, result, words = std::move(words), done = std::move(done)](
            WorkEnd end, const std::string& reason) {
          // What was done before Cancel could stop it was done.
          if (result->has_value()) {
            done(**result);
          } else if (end == WorkEnd::Failed) {
            say_failed(shell, words, reason);
          } else if (!words.stopped.empty()) {
            shell.say({Meaning::Info, words.stopped});
          }
        });
  }
  /// The same for a change that answers nothing.
  void change(Shell& shell, std::shared_ptr<SignedInSession> signed_in, WorkTexts words,
              std::function<void(database::Session&)> act, std::function<void()> done);
  void change_course(const Ui& ui, Shell& shell, std::shared_ptr<SignedInSession> signed_in,
                     CourseChange change);
  bool is_running() const noexcept { return work_.is_running(); }
  /// Why the last one failed, as a sentence; "" where it did not.
  const std::string& fault() const noexcept { return fault_; }
  void forget_fault() { fault_.clear(); }

 private:
  void say_failed(Shell& shell, const WorkTexts& words, const std::string& reason);

  std::string fault_;
  ScreenWork work_;
};

}  // namespace hallux::ui
