/// Who is signed in decides which places there are, by one table of routes; a screen asks its
/// caller (Course) for the next one, so no screen knows another. What must be told to the database
/// when somebody leaves is told beside the window: the connection may be in use, and nobody should
/// look at a window that stands still.
#include "ui/app/window/course.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "ui/screens/administrator/audit_screen.h"
#include "ui/screens/administrator/cohorts_screen.h"
#include "ui/screens/administrator/people_screen.h"
#include "ui/screens/administrator/scenarios_screen.h"
#include "ui/screens/devices/devices_screen.h"
#include "ui/screens/guide/guide_screen.h"
#include "ui/screens/instructor/attempts_screen.h"
#include "ui/screens/instructor/cohort_screen.h"
#include "ui/screens/instructor/trainee_screen.h"
#include "ui/screens/operating/flight/flight_screen.h"
#include "ui/screens/operating/operating_screen.h"
#include "ui/screens/parts/course_text.h"
#include "ui/screens/parts/desk_work.h"
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
#include "ui/times/local_time.h"

namespace hallux::ui {

namespace {

bool administers(const SignedInSession& signed_in) { return signed_in.person().is_administrator; }
bool teaches(const SignedInSession& signed_in) { return !signed_in.taught().empty(); }
bool is_staff(const SignedInSession& signed_in) {
  return administers(signed_in) || teaches(signed_in);
}
bool may_ask(const SignedInSession& signed_in) {
  return !administers(signed_in) || !signed_in.memberships().empty();
}
bool is_anybody(const SignedInSession&) { return true; }

constexpr double milli = 1000.0;

std::optional<double> of_milli(const std::optional<std::int32_t>& kept) {
  return kept ? std::optional(static_cast<double>(*kept) / milli) : std::nullopt;
}
std::optional<std::int32_t> to_milli(const std::optional<double>& chosen) {
  return chosen ? std::optional(static_cast<std::int32_t>(std::lround(milli * *chosen)))
                : std::nullopt;
}

HandPreferences hand_from(const database::HandSettings& kept) {
  return {kept.is_left_handed, of_milli(kept.motion_scale_milli), of_milli(kept.force_share_milli)};
}
database::HandSettings kept_from(const HandPreferences& hand) {
  return {hand.is_left_handed, to_milli(hand.motion_scale), to_milli(hand.force_share)};
}

}  // namespace

Course::Course(const Texts& texts, std::filesystem::path data_directory, Shell& shell,
               database::PasswordCost cost)
    : texts_(texts),
      data_directory_(std::move(data_directory)),
      shell_(shell),
      station_(std::make_shared<OwnStation>(data_directory_)),
      cost_(cost) {
  shell_.on_navigate([this](const std::string& id) { show_place(id); });
  shell_.on_account([this] { show_account(); });
  shell_.on_sign_out([this] { sign_out(); });
  shell_.on_hand([this](const HandPreferences& hand) { keep_hand(hand); });
  shell_.on_guide([](GuideSection section) { return std::make_unique<GuideScreen>(section); });
  ask_who();
}

void Course::ask_who() {
  shell_.set_visitor(std::nullopt);
  shell_.replace_all(std::make_unique<SignInScreen>(
      data_directory_,
      [this](Shell&, std::shared_ptr<SignedInSession> signed_in) { welcome(std::move(signed_in)); },
      cost_, &pictures_));
}

void Course::welcome(std::shared_ptr<SignedInSession> signed_in) {
  signed_in_ = std::move(signed_in);
  shell_.set_visitor(visitor_of(*signed_in_));
  shell_.set_hand(hand_from(signed_in_->hand_settings()));
  answer_drafts_ = std::make_shared<InboxScreen::Drafts>();
  made_replays_ = std::make_shared<MadeReplays>();
  count_questions();
  show_place(shell_.visitor()->places.front().id);
  shell_.on_idle(signed_in_->idle_lock_s(), [this] { lock(); });
  tell_notices();
}

void Course::lock() {
  if (!signed_in_) return;
  shell_.lock(std::make_unique<LockScreen>(
      signed_in_,
      [this] {
        shell_.unlock();
        sign_out();
      },
      cost_));
}

Visitor Course::visitor_of(const SignedInSession& signed_in) const {
  const database::Person& person = signed_in.person();
  Visitor visitor;
  visitor.name = person.display_name.empty() ? person.login : person.display_name;
  visitor.role = texts_.text(administers(signed_in) ? "role.administrator"
                             : teaches(signed_in)   ? "role.instructor"
                                                    : "role.trainee");
  visitor.initials = initials_of(visitor.name);
  visitor.hue = static_cast<int>(person.id.number % 6);
  visitor.places = places_of(signed_in);
  return visitor;
}

// In the order in which the navigation lists them: a place, who has it, and its screen.
std::span<const Course::Route> Course::routes() noexcept {
  using At = Course&;
  static constexpr std::array<Route, 11> all{{
      {"nav.people", "place.people", Icon::People, administers,
       [](At at) -> Shown { return std::make_unique<PeopleScreen>(at.signed_in_, at.cost_); }},
      {"nav.cohorts", "place.cohorts", Icon::Cohorts, administers,
       [](At at) -> Shown { return std::make_unique<CohortsScreen>(at.signed_in_); }},
      {"nav.scenarios", "place.scenarios", Icon::Scenarios, administers,
       [](At at) -> Shown { return std::make_unique<ScenariosScreen>(at.signed_in_); }},
      {"nav.records", "place.records", Icon::Audit, administers,
       [](At at) -> Shown { return std::make_unique<AuditScreen>(at.signed_in_); }},
      {"nav.cohort", "place.cohort", Icon::Cohort, teaches, &Course::cohort_screen},
      {"nav.inbox", "place.inbox", Icon::Inbox, teaches, &Course::inbox_screen},
      {"nav.operations", "place.operations", Icon::Operations, is_anybody,
       [](At at) -> Shown {
         return std::make_unique<OperationsScreen>(at.signed_in_, at, at.pictures_);
       }},
      {"nav.history", "place.history", Icon::History, is_anybody,
       [](At at) -> Shown { return std::make_unique<HistoryScreen>(at.signed_in_, at); }},
      {"nav.attempts", "place.attempts", Icon::Ratings, is_staff,
       [](At at) -> Shown { return std::make_unique<AttemptsScreen>(at.signed_in_, at); }},
      {"nav.questions", "place.questions", Icon::Messages, may_ask,
       [](At at) -> Shown { return std::make_unique<QuestionsScreen>(at.signed_in_, at); }},
      {"nav.devices", "place.devices", Icon::Devices, is_anybody,
       [](At at) -> Shown { return std::make_unique<DevicesScreen>(at.signed_in_, at.station_); }},
  }};
  return all;
}

Course::Shown Course::cohort_screen(Course& at) {
  return std::make_unique<CohortScreen>(at.signed_in_, at, [&at] { at.show_place("nav.inbox"); });
}

Course::Shown Course::inbox_screen(Course& at) {
  return std::make_unique<InboxScreen>(at.signed_in_, at, at.answer_drafts_,
                                       [&at](int open) { at.show_badge(open); });
}

std::vector<Visitor::Place> Course::places_of(const SignedInSession& signed_in) const {
  std::vector<Visitor::Place> places;
  for (const Route& route : routes()) {
    if (!route.is_for(signed_in)) continue;
    places.push_back({std::string(route.id), std::string(texts_.text(route.label)), route.icon});
  }
  return places;
}

void Course::show_place(std::string_view id) {
  for (const Route& route : routes())
    if (route.id == id) shell_.replace_all(route.screen(*this));
}

void Course::brief(database::ScenarioVersionId scenario) {
  shell_.push(std::make_unique<BriefingScreen>(signed_in_, *this, pictures_, scenario));
}
void Course::operate(database::ScenarioVersionId scenario, const WayToOperate& way) {
  // An operation needs the memory that replays of the expert take, 30 to 70 MB each.
  made_replays_ = std::make_shared<MadeReplays>();
  shell_.push(std::make_unique<OperatingScreen>(signed_in_, *this, OperationChoice{scenario, way},
                                                lend_hands()));
}
LendHands Course::lend_hands() const {
  const HandPreferences& hand = shell_.hand();
  return [station = station_, id = shell_.preferences().device,
          second = shell_.preferences().second_device,
          own = simulator::HandChoice{hand.motion_scale, hand.force_share}](
             const HandStart& start, const Progress& progress) {
    return station->lend({id, second, own}, start, progress);
  };
}
void Course::fly() { shell_.push(std::make_unique<FlightScreen>(signed_in_, lend_hands())); }
void Course::show_result(const database::AttemptId& attempt) {
  shell_.push(std::make_unique<ResultScreen>(signed_in_, *this, attempt));
}
void Course::show_trainee(database::CohortId cohort, database::PersonId trainee) {
  shell_.push(std::make_unique<TraineeScreen>(signed_in_, *this, cohort, trainee));
}
void Course::show_replay(const database::AttemptId& attempt, double moment_s) {
  shell_.push(std::make_unique<ReplayScreen>(signed_in_, attempt, moment_s));
}
void Course::watch_expert(const scenarios::Scenario& scenario) {
  shell_.push(std::make_unique<ReplayScreen>(signed_in_, made_replays_, scenario));
}

void Course::show_account() {
  if (shell_.top()->navigation_id() == AccountScreen::account_place) return;
  shell_.push(std::make_unique<AccountScreen>(signed_in_, cost_));
}

// The newest few; those that were not acknowledged are told again at the next sign-in.
void Course::tell_notices() {
  constexpr std::size_t told_max = 3;
  const std::vector<database::Notice>& notices = signed_in_->notices();
  for (std::size_t i = std::min(notices.size(), told_max); i > 0; --i) {
    const database::Notice notice = notices[i - 1];
    shell_.say({Meaning::Warn, notice_text(texts_, notice),
                texts_.say("notice.at", {{"moment", full_moment_text(notice.at_utc)}}),
                std::string(texts_.text("notice.seen")),
                [this, notice, signed_in = signed_in_] { acknowledge(signed_in, notice); }});
  }
}

void Course::acknowledge(std::shared_ptr<SignedInSession> signed_in,
                         const database::Notice& notice) {
  shell_.background().start(
      std::string(texts_.text("notice.noting")),
      [signed_in = std::move(signed_in), notice](WorkReport&) {
        signed_in->in_turn([&](database::Session& session, auto&) { session.acknowledge(notice); });
      },
      // Where that failed it is told again.
      [](WorkEnd, const std::string&) {});
}

void Course::keep_hand(const HandPreferences& hand) {
  if (!signed_in_) return;
  hand_to_keep_ = {signed_in_, kept_from(hand)};
  if (!is_keeping_hand_) keep_next_hand();
}

void Course::keep_next_hand() {
  if (!hand_to_keep_) return;
  is_keeping_hand_ = true;
  shell_.background().start(
      std::string(texts_.text("course.keeping_hand")),
      [kept = *std::exchange(hand_to_keep_, std::nullopt)](WorkReport&) {
        kept.whose->in_turn(
            [&](database::Session& session, auto&) { trainee_of(session).choose_hand(kept.hand); });
      },
      [this, failed = std::string(texts_.text("course.hand_unkept"))](WorkEnd end,
                                                                      const std::string& reason) {
        if (end == WorkEnd::Failed) shell_.say({Meaning::Warn, failed, sentence_of(reason)});
        is_keeping_hand_ = false;
        keep_next_hand();
      });
}

// The session's end is written beside the window: other work may hold the session for a moment.
void Course::sign_out() {
  made_replays_.reset();
  shell_.background().start(
      std::string(texts_.text("course.signing_out")),
      [signed_in = std::exchange(signed_in_, nullptr)](WorkReport&) {
        signed_in->in_turn([](database::Session& session, auto&) { session.sign_out(); });
      },
      [](WorkEnd, const std::string&) {});
  ask_who();
}

void Course::count_questions() {
  if (signed_in_->taught().empty()) return;
  auto open = std::make_shared<int>(0);
  shell_.background().start(
      std::string(texts_.text("course.counting")),
      [open, signed_in = signed_in_](WorkReport&) {
        *open = signed_in->in_turn([](database::Session& session, database::Database&) {
          return count_open(read_inbox(session));
        });
      },
      // Somebody else may have come in meanwhile. A count that failed leaves no badge; the inbox
      // says why.
      [this, open, signed_in = signed_in_](WorkEnd end, const std::string&) {
        if (end == WorkEnd::Done && signed_in == signed_in_) show_badge(*open);
      });
}

void Course::show_badge(int open_questions) { shell_.set_badge("nav.inbox", open_questions); }

}  // namespace hallux::ui
