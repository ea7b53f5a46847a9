#include "tests/database/whole_course.h"

#include <string>
#include <vector>

#include "database/course/begin_attempt.h"
#include "database/course/decisions.h"
#include "database/course/scores.h"
#include "database/desks/session.h"
#include "database/people/cohorts.h"
#include "database/people/people.h"
#include "database/recording/window_writer.h"
#include "tests/database/big_course.h"

namespace hallux::database {

namespace {

std::vector<WindowRows> windows_of(const simulator::Recording& recording) {
  std::vector<WindowRows> windows;
  const auto window_at = [&windows](std::int64_t tick) -> WindowRows& {
    const auto number = static_cast<std::size_t>(tick / window_ticks);
    if (windows.size() <= number) windows.resize(number + 1);
    return windows[number];
  };
  for (const simulator::TapeLine& line : recording.tape) window_at(line.tick).tape.push_back(line);
  for (const simulator::ToolSample& sample : recording.samples)
    window_at(sample.tick).samples.push_back(sample);
  for (const simulator::CutEvent& event : recording.events)
    window_at(event.tick).events.push_back(event);
  return windows;
}

/// Without the recorder's thread, which pauses between its passes.
AttemptId keep(Database& database, const NewAttempt& attempt,
               const std::vector<WindowRows>& windows, std::int64_t ticks) {
  const WriterLease lease = create_attempt(database, attempt);
  WindowWriter writer{database.open_again(), lease.attempt()};
  for (std::size_t i = 0; i < windows.size(); ++i)
    writer.commit(static_cast<std::int64_t>(i), windows[i]);
  seal_attempt(database, lease.attempt(), ticks, R"({"complete": true})", writer.last_link());
  return lease.attempt();
}

std::vector<PersonId> make_trainees(Database& database, std::int32_t count) {
  const CohortId autumn = create_cohort(database, "autumn");
  enrol(database, autumn, create_person_without_password(database, {"kim", "", false}),
        CohortRole::Instructor);
  std::vector<PersonId> trainees;
  for (std::int32_t number = 1; number <= count; ++number) {
    const std::string login = "trainee-" + std::to_string(number);
    trainees.push_back(create_person_without_password(database, {login, "Trainee", false}));
    enrol(database, autumn, trainees.back(), CohortRole::Trainee);
  }
  return trainees;
}

}  // namespace

void make_whole_course(Database& database, const WholeCourse& course, const std::string& password) {
  OpenHouse::enter(database)->add_first_administrator({"root", "", true}, secret(password), cheap);
  const PersonId root = find_person(database, "root").id;
  const std::vector<PersonId> trainees = make_trainees(database, course.trainees);
  const std::vector<WindowRows> windows = windows_of(some_recording(course.ticks));
  NewAttempt attempt = some_attempt(database);
  attempt.hand = "";
  ScoreCard card = card_of_usual_length(false);
  for (std::int32_t i = 0; i < course.attempts; ++i) {
    attempt.person = trainees[static_cast<std::size_t>(i) % trainees.size()];
    const AttemptId id = keep(database, attempt, windows, course.ticks);
    card.score_milli = 40'000 + i % 60'000;
    store_score(database, id, card, root);
    if (i % 10 == 0) decide(database, {id, DecisionKind::Confirmed, 0, "seen"}, root);
  }
}

}  // namespace hallux::database
