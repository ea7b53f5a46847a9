/// The course is made at the desks, as people would make it: so policy, audit, notices and
/// standings are those of a real one. Time is told to the database before each act and only moves
/// forward. Who asks, replies or is overruled follows from the trainee's number, so that each
/// screen has something of every kind.
#include "ui/jobs/demo/demo_people.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <ctime>
#include <nlohmann/json.hpp>
#include <thread>

#include "database/content/assets.h"
#include "database/course/simulated_course.h"
#include "simulator/mesh/bone.h"
#include "ui/jobs/attempt_jobs.h"
#include "ui/jobs/course/course_jobs.h"

namespace hallux::ui {

namespace {

using database::CohortRole;
using database::DecisionKind;

constexpr const char* administrator_login = "administrator";
/// Whoever comes after an attempt comes this much later.
constexpr std::int64_t minutes_until_talk = 20;

std::string trainee_login(int number) { return "trainee-" + std::to_string(number); }
std::string instructor_login(int number) { return "instructor-" + std::to_string(number); }
/// "Trainee 3": nobody's name. That the course is simulated stands on every screen beside it.
std::string shown_name(std::string login) {
  std::replace(login.begin(), login.end(), '-', ' ');
  login.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(login.front())));
  return login;
}

std::string utc_text(std::int64_t seconds) {
  const auto time = static_cast<std::time_t>(seconds);
  std::tm parts{};
  gmtime_r(&time, &parts);
  std::array<char, 32> text{};
  std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%S.000Z", &parts);
  return text.data();
}

/// The loss that cost most; the first line where nothing was lost.
const database::LedgerLine* costliest(const database::ScoreCard& card) {
  const auto worst =
      std::max_element(card.ledger.begin(), card.ledger.end(),
                       [](const database::LedgerLine& a, const database::LedgerLine& b) {
                         return a.points_lost_milli < b.points_lost_milli;
                       });
  return worst == card.ledger.end() ? nullptr : &*worst;
}

/// Pushes a recording as the loop does, waiting for room.
void push_all(const simulator::Recording& recording, simulator::AttemptChannels& channels) {
  const auto push = [&channels](auto& ring, const auto& rows) {
    for (const auto& row : rows) {
      while (!ring.push(row) && !channels.recorder_failed.load()) std::this_thread::yield();
    }
  };
  push(channels.tape, recording.tape);
  push(channels.samples, recording.samples);
  push(channels.events, recording.events);
  channels.closed.store(true);
}

/// A scenario that is none of the shipped ones: the text with other facts about itself.
scenarios::Scenario changed_scenario(const scenarios::Scenario& scenario, const std::string& name,
                                     std::int32_t version) {
  auto document = nlohmann::ordered_json::parse(scenario.text);
  document["name"] = name;
  document["version"] = version;
  document["title"] = scenario.title + " (simulated change)";
  return scenarios::parse_scenario(document.dump(2), name);
}

}  // namespace

DemoPeople::DemoPeople(database::Database& database, const DemoOptions& options)
    : database_(database), cost_(options.cost) {
  const database::SecretText random = database::random_code();
  course_.password = "demo " + std::string{random.view()};
  begun_s_ = static_cast<std::int64_t>(std::time(nullptr)) - 60 * demo_minutes;
  // Days of the plan count from midnight.
  begun_s_ -= begun_s_ % (24LL * 60 * 60);
  set_time(8LL * 60);
  database::mark_as_simulated_course(database_);
}

void DemoPeople::set_time(std::int64_t minute) {
  minute_ = std::max(minute_, minute);
  database_.pretend_it_is(utc_text(begun_s_ + 60 * minute_));
}

database::SecretText DemoPeople::password(const char* mistyped) const {
  std::string text = course_.password + mistyped;
  return database::SecretText::take(text);
}

database::Session DemoPeople::sign_in(const std::string& login) {
  return database::sign_in(database_, login, password(), cost_);
}

void DemoPeople::found(const std::vector<DemoOperation>& operated) {
  database::OpenHouse::enter(database_)->add_first_administrator(
      {administrator_login, shown_name(administrator_login), true}, password(), cost_);
  course_.accounts.push_back({administrator_login, "administrator"});
  database::Session session = sign_in(administrator_login);
  database::AdministratorDesk desk = *session.administrator();
  add_people(desk);
  add_cohorts(desk);
  add_catalogue(desk, operated);
  session.sign_out();
  for (std::size_t i = 0; i < operated.size(); ++i) {
    database::NewAttempt begun;
    begun.scenario = versions_[i];
    begun.bone = put_asset(database_, "bone", simulator::encode_patient(operated[i].bones));
    begun_.push_back(begun);
    measured_by_.push_back(measured_by(operated[i].scenario, begun.bone));
  }
}

void DemoPeople::add_people(database::AdministratorDesk& desk) {
  const auto add = [&](const std::string& login, const char* role) {
    // The code is used at once: it need not withstand guessing for a week.
    const database::AddedPerson added =
        desk.add_person_with_code({login, shown_name(login), false}, {1, 8192});
    database::redeem_code(database_, login, added.issued.code, password(), cost_).sign_out();
    course_.accounts.push_back({login, role});
  };
  for (int i = 1; i <= demo_instructors; ++i) add(instructor_login(i), "instructor");
  for (int i = 1; i <= demo_trainees; ++i) add(trainee_login(i), "trainee");
}

void DemoPeople::add_cohorts(database::AdministratorDesk& desk) {
  cohort_a_ = desk.add_cohort("Cohort A");
  cohort_b_ = desk.add_cohort("Cohort B");
  desk.enrol(cohort_a_, instructor_login(1), CohortRole::Instructor);
  desk.enrol(cohort_b_, instructor_login(2), CohortRole::Instructor);
  desk.enrol(cohort_a_, instructor_login(2), CohortRole::Trainee);
  for (int i = 1; i <= demo_trainees; ++i) {
    desk.enrol(i <= demo_trainees_of_first_cohort ? cohort_a_ : cohort_b_, trainee_login(i),
               CohortRole::Trainee);
  }
}

void DemoPeople::add_catalogue(database::AdministratorDesk& desk,
                               const std::vector<DemoOperation>& operated) {
  const auto import_version = [&](const scenarios::Scenario& scenario) {
    return desk.import_scenario(
        {scenario.name, scenario.version, scenario.text, scenario.claims_review});
  };
  for (const DemoOperation& operation : operated) {
    versions_.push_back(import_version(operation.scenario));
    desk.publish_scenario(versions_.back());
  }
  const scenarios::Scenario& first = operated.front().scenario;
  import_version(changed_scenario(first, first.name, first.version + 1));
  const auto tried = import_version(changed_scenario(first, first.name + "_trial", 1));
  desk.publish_scenario(tried);
  desk.retire_scenario(tried);
}

DemoPeople::Kept DemoPeople::keep(const OperatedAttempt& operated) {
  const DemoAttempt& planned = operated.planned;
  database::Session session = sign_in(trainee_login(planned.trainee));
  database::TraineeDesk desk = *session.trainee();
  database::NewAttempt begun = begun_[planned.scenario];
  begun.person = session.person().id;
  begun.hand = demo_hand_name(planned.skill);
  begun.seed = planned.seed;
  begun.kind = planned.kind;
  simulator::AttemptChannels channels;
  database::Recorder recorder(database_, desk.begin_attempt(begun), channels);
  push_all(operated.recording, channels);
  recorder.finish(quality_json(quality_of(operated.loop, recorder.drain())));
  desk.store_score(recorder.attempt(), operated.card);
  desk.store_measurements(recorder.attempt(), measured_by_[planned.scenario],
                          operated.measurements);
  session.sign_out();

  Kept kept;
  kept.id = recorder.attempt();
  kept.minute = planned.minute;
  kept.trainee = planned.trainee;
  kept.score_milli = operated.card.score_milli;
  if (const database::LedgerLine* line = costliest(operated.card)) {
    const std::int64_t last_us = 1000 * (operated.loop.ticks - 1);
    kept.moment = {std::clamp<std::int64_t>(line->start_us, 0, std::max<std::int64_t>(last_us, 0)),
                   database::BonePoint{0, line->place_in_bone_mm}};
    kept.remark = line->text;
  }
  ++course_.attempts;
  return kept;
}

void DemoPeople::add(const OperatedAttempt& operated) {
  set_time(operated.planned.minute);
  const Kept kept = keep(operated);
  set_time(operated.planned.minute + minutes_until_talk);
  if (operated.planned.number == 0) talk(kept);
  if (!operated.planned.is_last) return;
  ask(kept);
  decide(kept);
}

database::InstructorDesk DemoPeople::desk_of_instructor(int trainee) {
  const bool is_first = trainee <= demo_trainees_of_first_cohort;
  database::Session session = sign_in(instructor_login(is_first ? 1 : 2));
  return *session.instructor_of(is_first ? cohort_a_ : cohort_b_);
}

void DemoPeople::talk(const Kept& kept) {
  database::InstructorDesk desk = desk_of_instructor(kept.trainee);
  desk.recording(kept.id);
  const database::NoteId note =
      desk.add_note({kept.id, kept.moment, false, "This cost you most. " + kept.remark});
  ++course_.notes;
  if (kept.trainee % 5 == 1) {
    desk.add_note({kept.id, {}, true, "Look at the next attempt together before the assessment."});
    ++course_.notes;
  }
  if (kept.trainee == 3) mistype_password(kept.trainee);
  if (kept.trainee % 2 == 0) return;
  sign_in(trainee_login(kept.trainee))
      .trainee()
      ->reply(note, "I see it in the replay now. Which drill should I do?");
  desk.reply(note, "The same operation in practice mode, with the plane shown.");
  course_.replies += 2;
}

/// So that the audit has a refusal to show.
void DemoPeople::mistype_password(int trainee) {
  try {
    database::sign_in(database_, trainee_login(trainee), password("?"), cost_);
  } catch (const database::DatabaseError& error) {
    if (error.kind() != database::DatabaseErrorKind::Refused) throw;
  }
}

void DemoPeople::ask(const Kept& kept) {
  if (kept.trainee % 3 == 0) return;
  const database::HelpRequestId request =
      sign_in(trainee_login(kept.trainee))
          .trainee()
          ->ask_for_help({kept.id, kept.moment, "Why did I lose points here?"});
  ++course_.help_requests;
  if (kept.trainee % 4 != 1) return;
  desk_of_instructor(kept.trainee).answer(request, kept.remark);
}

void DemoPeople::decide(const Kept& kept) {
  constexpr std::int64_t added_milli = 5000;
  database::NewDecision decision{kept.id, DecisionKind::Confirmed, 0, "Seen in the replay."};
  switch (kept.trainee) {
    case 1:
      decision.kind = DecisionKind::Overridden;
      decision.score_milli = std::min<std::int64_t>(kept.score_milli + added_milli, 100'000);
      decision.reason = "The last loss came from the table, which was moved during the cut.";
      break;
    case 3:
      decision.kind = DecisionKind::Voided;
      decision.reason = "The station was restarted during the attempt; it will be repeated.";
      break;
    case 2:
    case 6:
      break;
    default:
      return;
  }
  database::InstructorDesk desk = desk_of_instructor(kept.trainee);
  desk.recording(kept.id);
  desk.decide(decision);
  ++course_.decisions;
  if (kept.trainee == 1) acknowledge_all(trainee_login(kept.trainee));
}

/// This one was here since; what the others were told waits for them.
void DemoPeople::acknowledge_all(const std::string& login) {
  database::Session session = sign_in(login);
  for (const database::Notice& notice : session.notices()) session.acknowledge(notice);
}

}  // namespace hallux::ui
