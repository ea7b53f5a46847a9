/// From whole attempts to a competent person: what the hand does is recorded, scored by the whole
/// rubric, and judged.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "assessment/pass_mark.h"
#include "tests/database/some_course.h"
#include "ui/jobs/course/course_jobs.h"
#include "ui/jobs/course/standing_jobs.h"
#include "ui/jobs/made_attempt.h"

namespace hallux::ui {
namespace {

const StageProgress untold = [](const std::string&) { return Progress(); };

/// The shipped Silver on a patient that is built and sawn in a moment.
scenarios::Scenario coarse_silver() {
  auto text = nlohmann::ordered_json::parse(scenarios::load_shipped_scenario("silver").text);
  text["patient"]["bones"][0]["edge_mm"] = 1.5;
  return scenarios::parse_scenario(text.dump(), "coarse silver");
}

/// Assessments of ada's by a hand without error, in a course in which the Silver is published.
class CleanRuns {
 public:
  CleanRuns() : scenario_(coarse_silver()) {
    database::AdministratorDesk desk = course_.administrator();
    published_ = import_scenario(desk, scenario_);
    desk.publish_scenario(published_);
  }

  /// Recorded and scored as a person's.
  database::ScoreCard add(std::uint64_t seed) {
    ScriptedAttempt attempt;
    attempt.scenario = scenario_;
    attempt.hand = "perfect";
    attempt.seed = seed;
    const MadeAttempt made = make_attempt(attempt, untold);
    database::NewAttempt begun = course_.attempt_of("ada");
    begun.scenario = published_;
    begun.kind = database::AttemptKind::Assessment;
    begun.engine = made.material.recording.engine;
    put_patient(course_.database(), made.material.bones, begun);
    const database::AttemptId id = record(course_.database(), begun, made.material.recording);
    course_.trainee("ada").store_score(id, made.card);
    return made.card;
  }
  assessment::LearningState learning() {
    database::Session session = course_.sign_in_as("ada");
    return own_operation(session, course_.database(), published_).learning;
  }

 private:
  database::SomeCourse course_;
  scenarios::Scenario scenario_;
  database::ScenarioVersionId published_;
};

TEST(CleanRuns, TwelveMakeSomebodyCompetent) {
  CleanRuns runs;
  ASSERT_EQ(assessment::clean_runs_needed(), 12);
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    EXPECT_FALSE(runs.learning().is_competent) << "after " << seed - 1;
    const database::ScoreCard card = runs.add(seed);
    EXPECT_EQ(card.measured_milli, 100'000);
    EXPECT_EQ(assessment::pass_answer(card, card.score_milli), assessment::PassAnswer::Reached)
        << card.score_milli;
  }
  EXPECT_TRUE(runs.learning().is_competent);
}

}  // namespace
}  // namespace hallux::ui
