#include "ui/app/window/course.h"

#include <algorithm>
#include <utility>

#include "simulator/device/mouse.h"
#include "ui/screens/instructor/attempts_screen.h"
#include "ui/screens/instructor/trainee_screen.h"
#include "ui/screens/operating/operating_screen.h"
#include "ui/screens/parts/notice_text.h"
#include "ui/screens/parts/value_text.h"
#include "ui/screens/replay/replay_screen.h"
#include "ui/screens/result/result_screen.h"
#include "ui/screens/sign_in/account_screen.h"
#include "ui/screens/sign_in/lock_screen.h"
#include "ui/screens/sign_in/sign_in_screen.h"
#include "ui/screens/trainee/briefing_screen.h"
#include "ui/screens/trainee/history_screen.h"
#include "ui/screens/trainee/operations_screen.h"
#include "ui/screens/trainee/questions_screen.h"

namespace hallux::ui {

Course::Course(const Texts& texts, std::filesystem::path data_directory, Shell& shell,
               database::PasswordCost cost)
    : texts_(texts), data_directory_(std::move(data_directory)), shell_(shell), cost_(cost) {
  shell_.on_navigate([this](const std::string& id) { show_place(id); });
  shell_.on_account([this] { show_account(); });
  shell_.on_sign_out([this] { sign_out(); });
  ask_who();
}

void Course::ask_who() {
  shell_.set_visitor(std::nullopt);
  shell_.replace_all(std::make_unique<EntryScreen>(
      data_directory_, [this](Shell&, std::shared_ptr<Visit> visit) { welcome(std::move(visit)); },
      cost_, &pictures_));
}

void Course::welcome(std::shared_ptr<Visit> visit) {
  visit_ = std::move(visit);
  shell_.set_visitor(visitor_of(*visit_));
  answer_drafts_ = std::make_shared<InboxScreen::Drafts>();
  count_questions();
  show_place(shell_.visitor()->places.front().id);
  shell_.on_idle(visit_->idle_lock_s(), [this] { lock(); });
  tell_notices();
}

void Course::lock() {
  if (!visit_) return;
  shell_.lock(std::make_unique<LockScreen>(
      visit_,
      [this] {
        shell_.unlock();
        sign_out();
      },
      cost_));
}

Visitor Course::visitor_of(const Visit& visit) const {
  const database::Person& person = visit.person();
  Visitor visitor;
  visitor.name = person.display_name.empty() ? person.login : person.display_name;
  visitor.role = texts_.text(person.is_administrator   ? "role.administrator"
                             : !visit.taught().empty() ? "role.instructor"
                                                       : "role.trainee");
  visitor.initials = initials_of(visitor.name);
  visitor.hue = static_cast<int>(person.id.number % 6);
  visitor.places = places_of(visit);
  return visitor;
}

std::vector<Visitor::Place> Course::places_of(const Visit& visit) const {
  std::vector<Visitor::Place> places;
  const auto add = [&](const char* id, std::string_view label, Icon icon) {
    places.push_back({id, std::string(label), icon});
  };
  add_staff_places(visit, places);
  add("nav.operations", texts_.text("place.operations"), Icon::Operations);
  add("nav.history", texts_.text("place.history"), Icon::History);
  const bool is_trainee = !visit.person().is_administrator && visit.taught().empty();
  if (!is_trainee) add("nav.attempts", texts_.text("place.attempts"), Icon::Ratings);
  if (!visit.person().is_administrator || !visit.memberships().empty())
    add("nav.questions", texts_.text("place.questions"), Icon::Messages);
  return places;
}

void Course::show_place(const std::string& id) {
  if (show_staff_place(id)) return;
  if (id == "nav.attempts") {
    shell_.replace_all(std::make_unique<AttemptsScreen>(visit_, *this));
  }
  if (id == "nav.questions") {
    shell_.replace_all(std::make_unique<QuestionsScreen>(visit_, *this));
  }
  if (id == "nav.operations") {
    shell_.replace_all(std::make_unique<OperationsScreen>(visit_, *this, pictures_));
  }
  if (id == "nav.history") shell_.replace_all(std::make_unique<HistoryScreen>(visit_, *this));
}

void Course::brief(database::ScenarioVersionId scenario) {
  shell_.push(std::make_unique<BriefingScreen>(visit_, *this, pictures_, scenario));
}
void Course::operate(database::ScenarioVersionId scenario, database::AttemptKind kind,
                     simulator::Guidance guidance) {
  shell_.push(std::make_unique<OperatingScreen>(
      visit_, *this, OperationChoice{scenario, kind, guidance},
      [](const RigidTransform& world_from_start) {
        return std::make_unique<simulator::MouseDevice>(world_from_start);
      }));
}
void Course::show_result(const database::AttemptId& attempt) {
  shell_.push(std::make_unique<ResultScreen>(visit_, *this, attempt));
}
void Course::show_trainee(database::CohortId cohort, database::PersonId trainee) {
  shell_.push(std::make_unique<TraineeScreen>(visit_, *this, cohort, trainee));
}
void Course::show_replay(const database::AttemptId& attempt, double moment_s) {
  shell_.push(std::make_unique<ReplayScreen>(visit_, attempt, moment_s));
}

void Course::show_account() {
  if (shell_.top()->navigation_id() == AccountScreen::account_place) return;
  shell_.push(std::make_unique<AccountScreen>(visit_, cost_));
}

// The newest few; those that were not acknowledged are told again at the next sign-in.
void Course::tell_notices() {
  constexpr std::size_t told_max = 3;
  const std::vector<database::Notice>& notices = visit_->notices();
  for (std::size_t i = std::min(notices.size(), told_max); i > 0; --i) {
    const database::Notice notice = notices[i - 1];
    shell_.say({Meaning::Warn, notice_text(texts_, notice),
                texts_.say("notice.at", {{"moment", moment_text(notice.at_utc)}}),
                std::string(texts_.text("notice.seen")),
                [this, notice, visit = visit_] { acknowledge(visit, notice); }});
  }
}

void Course::acknowledge(std::shared_ptr<Visit> visit, const database::Notice& notice) {
  shell_.background().start(
      std::string(texts_.text("notice.noting")),
      [visit = std::move(visit), notice](WorkReport&) {
        visit->in_turn([&](database::Session& session, auto&) { session.acknowledge(notice); });
      },
      // Where that failed it is told again.
      [](WorkEnd, const std::string&) {});
}

// The end of the session is written beside the window: other work may hold the visit for a moment.
void Course::sign_out() {
  shell_.background().start(
      std::string(texts_.text("course.signing_out")),
      [visit = std::exchange(visit_, nullptr)](WorkReport&) {
        visit->in_turn([](database::Session& session, auto&) { session.sign_out(); });
      },
      [](WorkEnd, const std::string&) {});
  ask_who();
}

}  // namespace hallux::ui
