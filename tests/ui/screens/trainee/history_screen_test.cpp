#include "ui/screens/trainee/history_screen.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/time_zone.h"
#include "tests/ui/screens/some_navigator.h"
#include "tests/ui/screens/some_published.h"
#include "tests/ui/screens/some_visitor.h"

namespace hallux::ui {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// A person who looks back.
struct Looker {
  Looker(SomePublished& published, const std::string& login, float scale = 1.0F)
      : visitor(std::make_unique<HistoryScreen>(visit_of(published.course(), login), navigator),
                scale) {}
  Driver& driver() { return visitor.driver(); }

  SomeNavigator navigator;
  SomeVisitor visitor;
};

void make_void(SomePublished& published, const database::AttemptId& attempt) {
  database::NewDecision decision;
  decision.attempt = attempt;
  decision.kind = database::DecisionKind::Voided;
  decision.reason = "the saw was not calibrated";
  published.course().instructor("kim", published.course().autumn()).decide(decision);
}

std::vector<JudgedAttempt> own_of(SomePublished& published, const std::string& login) {
  database::Session session = published.course().sign_in_as(login);
  return own_attempts(session);
}

TEST(HistoryScreen, SaysWhereThereIsNone) {
  SomePublished published;
  Looker looker(published, "ada");
  EXPECT_TRUE(looker.driver().sees("No attempts yet"));
  EXPECT_THAT(looker.driver().faults(), IsEmpty());
}

TEST(HistoryScreen, ShowsOnlyTheOwnAttempts) {
  SomePublished published;
  published.scored_by("ada", 76830);
  published.scored_by("bob", 31250);
  Looker looker(published, "ada");
  EXPECT_TRUE(looker.driver().sees("76.8"));
  EXPECT_FALSE(looker.driver().sees("31.3"));
}

TEST(HistoryScreen, InstructorsSeeTheirOwnHereAndNotTheCohorts) {
  SomePublished published;
  published.scored_by("ada", 76830);
  Looker looker(published, "kim");
  EXPECT_TRUE(looker.driver().sees("No attempts yet"));
}

TEST(History, VoidAttemptsDoNotCountAndUnscoredOnesAreGaps) {
  SomePublished published;
  published.scored_by("ada", 40000);
  make_void(published, published.scored_by("ada", 99000));
  published.attempted_by("ada", database::AttemptKind::Practice);
  published.scored_by("ada", 50000);
  const std::vector<OperationHistory> histories = histories_of(own_of(published, "ada"));
  ASSERT_EQ(histories.size(), 1U);
  const OperationHistory& history = histories.front();
  EXPECT_EQ(history.attempts.size(), 4U);
  EXPECT_THAT(history.counted, ElementsAre(0U, 2U, 3U));
  ASSERT_EQ(history.scores.size(), 3U);
  EXPECT_EQ(history.scores[0].x, 1.0);
  EXPECT_EQ(history.scores[1].x, 3.0) << "the number that everybody calls it by";
  EXPECT_EQ(history.scores[0].y, 40.0);
  EXPECT_TRUE(std::isnan(history.scores[1].y));
  EXPECT_EQ(history.scores[2].y, 50.0);
  EXPECT_TRUE(std::isnan(history.medians[1].y));
  EXPECT_EQ(history.medians[2].y, 45.0);
}

TEST(History, TheMedianIsOfOneDeviceClassAndOfUnguidedHands) {
  const auto attempt = [](const char* device_class, simulator::Guidance guidance,
                          std::int64_t points) {
    JudgedAttempt made;
    made.header.scenario_name = "akin";
    made.header.begun.device_class = device_class;
    made.header.begun.guidance = guidance;
    made.score_milli = 1000 * points;
    return made;
  };
  const OperationHistory history = histories_of({attempt("mouse", simulator::Guidance::None, 40),
                                                 attempt("mouse", simulator::Guidance::Slot, 99),
                                                 attempt("mouse", simulator::Guidance::None, 60),
                                                 attempt("arm", simulator::Guidance::None, 20),
                                                 attempt("mouse", simulator::Guidance::None, 70)})
                                       .front();
  ASSERT_EQ(history.medians.size(), 5U);
  EXPECT_EQ(history.medians[0].y, 40.0);
  EXPECT_TRUE(std::isnan(history.medians[1].y));
  EXPECT_EQ(history.scores[1].y, 99.0) << "its score is shown";
  EXPECT_EQ(history.medians[2].y, 50.0);
  EXPECT_EQ(history.medians[3].y, 20.0);
  EXPECT_EQ(history.medians[4].y, 60.0);
}

TEST(History, WhoIsCompetentByMouseIsNotYetByAnArm) {
  std::vector<JudgedAttempt> attempts;
  const auto pass = [&](const char* device_class) {
    JudgedAttempt& made = attempts.emplace_back();
    made.header.scenario_name = "akin";
    made.header.begun.kind = database::AttemptKind::Assessment;
    made.header.begun.device_class = device_class;
    made.pass = assessment::PassAnswer::Reached;
    made.rubric_version = 1;
  };
  for (int run = 0; run < assessment::clean_runs_needed(); ++run) pass("mouse");
  EXPECT_TRUE(learning_of(attempts, "akin").is_competent);
  pass("arm");
  EXPECT_FALSE(learning_of(attempts, "akin").is_competent);
  EXPECT_EQ(learning_of(attempts, "akin").clean_runs(), 1);
  pass("mouse");
  EXPECT_TRUE(learning_of(attempts, "akin").is_competent);
}

TEST(History, AnOverriddenScoreStandsInPlaceOfTheMachines) {
  SomePublished published;
  database::NewDecision decision;
  decision.attempt = published.scored_by("ada", 52000, database::AttemptKind::Assessment);
  decision.kind = database::DecisionKind::Overridden;
  decision.score_milli = 72000;
  decision.reason = "the depth was measured beside a defect";
  published.course().instructor("kim", published.course().autumn()).decide(decision);
  const std::vector<JudgedAttempt> own = own_of(published, "ada");
  ASSERT_EQ(own.size(), 1U);
  EXPECT_EQ(own.front().score_milli, 72000);
  EXPECT_EQ(own.front().pass, assessment::PassAnswer::Reached);
}

TEST(HistoryScreen, AGuidedPracticeIsListedAndCopiedAsOne) {
  SomePublished published;
  published.scored_by("ada", 40000);
  Looker unguided(published, "ada");
  EXPECT_FALSE(unguided.driver().sees("Guided"));
  published.attempted_by("ada", database::AttemptKind::Practice, simulator::Guidance::Soft);
  Looker looker(published, "ada");
  EXPECT_TRUE(looker.driver().sees("Guided"));
  const std::string csv = csv_of(histories_of(own_of(published, "ada")).front());
  EXPECT_THAT(csv, HasSubstr(",practice,scripted,none,40"));
  EXPECT_THAT(csv, HasSubstr(",practice,scripted,soft,"));
}

TEST(HistoryScreen, APracticeDoesNotCountAndAnAssessmentIsAdvisory) {
  SomePublished published;
  published.scored_by("ada", 40000);
  Looker practised(published, "ada");
  EXPECT_TRUE(practised.driver().sees("Does not count"));
  EXPECT_FALSE(practised.driver().sees("Advisory"));
  published.assessed("ada", 1, 50000);
  Looker assessed(published, "ada");
  EXPECT_TRUE(assessed.driver().sees("Advisory"));
}

TEST(HistoryScreen, TheFactsAreOfWhatCounts) {
  SomePublished published;
  published.scored_by("ada", 40000);  // recorded for five milliseconds
  published.scored_by("ada", 81400);
  published.scored_by("ada", 61000, database::AttemptKind::Assessment);
  make_void(published, published.scored_by("ada", 99000));
  Looker looker(published, "ada");
  for (const char* words :
       {"81.4", "61.0", "2 practice, 1 assessed", "1 of 12", "pass 60, provisional", "00:00"}) {
    EXPECT_TRUE(looker.driver().sees(words)) << words;
  }
  EXPECT_FALSE(looker.driver().sees("99.0"));
  EXPECT_TRUE(looker.driver().sees("Void"));
}

/// An assessment that is a grade, of somebody of autumn.
void graded(SomePublished& published, database::PersonId person, std::int64_t score_milli) {
  database::Database& database = published.course().database();
  database::NewAttempt attempt = published.course().attempt_of("ada");
  attempt.scenario = published.akin();
  attempt.person = person;
  attempt.kind = database::AttemptKind::Assessment;
  const database::AttemptId id = database::record(database, attempt, database::some_recording(5));
  database::ScoreCard card = database::card_worth(score_milli);
  card.measured_milli = card.rubric_milli = 100'000;
  database::store_score(database, id, card);
  database::decide(database, {id, database::DecisionKind::Confirmed, 0, "seen"},
                   published.course().id_of("kim"));
}

TEST(HistoryScreen, ShowsHowTheCohortStandsOnceItIsLargeEnough) {
  SomePublished published;
  graded(published, published.course().id_of("ada"), 70000);
  Looker alone(published, "ada");
  EXPECT_FALSE(alone.driver().sees("autumn"));
  for (int number = 1; number <= 19; ++number) {
    const std::string login = "trainee-" + std::to_string(number);
    database::Database& database = published.course().database();
    const database::PersonId person =
        database::create_person_without_password(database, {login, "", false});
    database::enrol(database, published.course().autumn(), person, database::CohortRole::Trainee);
    graded(published, person, number * 5000);
  }
  Looker looker(published, "ada");
  EXPECT_TRUE(looker.driver().sees("autumn, median"));
  EXPECT_TRUE(looker.driver().sees("Of 20 people"));
  EXPECT_FALSE(looker.driver().sees("trainee-1"));
  EXPECT_THAT(looker.driver().faults(), IsEmpty());
}

TEST(HistoryScreen, SaysThatTheEvidenceIsEnough) {
  SomePublished published;
  published.assessed("ada", 12, 60000);
  Looker competent(published, "ada");
  EXPECT_TRUE(competent.driver().sees("Enough: you are competent"));
  EXPECT_THAT(competent.driver().faults(), IsEmpty());
  published.assessed("ada", 3, 40000);
  Looker slipped(published, "ada");
  EXPECT_TRUE(slipped.driver().sees("You were competent and slipped"));
}

TEST(HistoryScreen, RowsAndPointsLeadToTheirResult) {
  SomePublished published;
  const database::AttemptId first = published.scored_by("ada", 40000);
  const database::AttemptId second = published.scored_by("ada", 50000);
  Looker looker(published, "ada");
  looker.driver().click("history.chart.0");
  looker.driver().click("history.list.2");
  EXPECT_THAT(looker.navigator.asked, ElementsAre("result " + first.text, "result " + second.text));
}

TEST(HistoryScreen, AResultIsReachedByKeyboardAlone) {
  SomePublished published;
  const database::AttemptId attempt = published.scored_by("ada", 40000);
  Looker looker(published, "ada");
  for (int tab = 0; tab < 12 && looker.driver().focused() != "history.chart.0"; ++tab) {
    looker.driver().press(Key::Tab);
  }
  ASSERT_EQ(looker.driver().focused(), "history.chart.0");
  EXPECT_TRUE(looker.driver().sees("40.0 points"));
  looker.driver().press(Key::Tab);
  EXPECT_EQ(looker.driver().focused(), "history.list.1");
  looker.driver().press(Key::Enter);
  EXPECT_THAT(looker.navigator.asked, ElementsAre("result " + attempt.text));
}

TEST(HistoryScreen, OneOperationAtATime) {
  SomePublished published;
  published.course().scored_by("ada", 31250);  // of the silver
  published.scored_by("ada", 76830);
  Looker looker(published, "ada");
  EXPECT_TRUE(looker.driver().sees("76.8")) << "the newest first";
  EXPECT_FALSE(looker.driver().sees("31.3"));
  looker.driver().click("history.operation.1");
  EXPECT_TRUE(looker.driver().sees("31.3"));
  EXPECT_FALSE(looker.driver().sees("76.8"));
}

TEST(HistoryScreen, CopiesTheChartsNumbersByButtonAndByKey) {
  SomePublished published;
  published.scored_by("ada", 40000);
  published.attempted_by("ada", database::AttemptKind::Assessment);
  Looker looker(published, "ada");
  looker.driver().press(Key::C, {.control = true});
  const std::string csv = looker.driver().clipboard().read();
  EXPECT_THAT(csv, HasSubstr("attempt,begun_utc,for,device,guidance,score,median_of_5\n1,"));
  EXPECT_THAT(csv, HasSubstr(",practice,scripted,none,40.0,40.0\n2,"));
  EXPECT_THAT(csv, HasSubstr(",assessment,scripted,none,,\n"));
  EXPECT_TRUE(looker.driver().sees("2 attempts copied"));
  looker.driver().clipboard().write("");
  looker.driver().click("history.copy");
  EXPECT_EQ(looker.driver().clipboard().read(), csv);
}

TEST(HistoryScreen, TimesAreLocalAndTheirOffsetIsToldOnHover) {
  const TimeZone nepal("NPT-5:45");
  SomePublished published;
  published.course().database().pretend_it_is("2026-03-03T14:02:59.000Z");
  published.scored_by("ada", 76830);
  published.course().database().pretend_it_is("");
  Looker looker(published, "ada");
  const auto place_of = [&](std::string_view words) {
    for (const SeenText& seen : looker.driver().content().texts)
      if (seen.text == words && !seen.hint.empty()) return seen.rect.centre();
    return Point{};
  };
  const Point moment = place_of("3 Mar 2026, 19:47");
  ASSERT_NE(moment, Point{});
  looker.driver().move_to(moment);
  looker.driver().wait(1.0);
  EXPECT_TRUE(looker.driver().sees("3 Mar 2026, 19:47 +05:45"));
  long without_offset = 0;
  for (const SeenText& seen : looker.driver().content().texts) {
    if (seen.text.find("19:47") == std::string::npos || seen.text.ends_with("+05:45")) continue;
    ++without_offset;
    EXPECT_THAT(seen.hint, HasSubstr("19:47 +05:45")) << seen.text;
  }
  EXPECT_EQ(without_offset, 3) << "the best, the last, and the attempt in its list";
  looker.driver().move_to(looker.driver().widget("history.chart.0").rect.centre());
  EXPECT_TRUE(looker.driver().sees("Attempt 1, 3 Mar 2026, 19:47 +05:45, Practice"));
  looker.driver().click("history.copy");
  EXPECT_THAT(looker.driver().clipboard().read(), HasSubstr("2026-03-03T14:02:59.000Z"))
      << "what other programs read stays UTC";
}

TEST(HistoryScreen, NothingIsCutOffAtAnyScaleAndSize) {
  SomePublished published;
  published.course().scored_by("ada", 31250);
  published.scored_by("ada", 76830);
  published.attempted_by("ada", database::AttemptKind::Practice);
  for (const float scale : {0.8F, 1.0F, 1.5F, 2.0F}) {
    Looker looker(published, "ada", scale);
    EXPECT_THAT(looker.driver().faults(), IsEmpty()) << scale;
    for (const auto& [width, height] : {std::pair(1280.0F, 720.0F), std::pair(3840.0F, 2160.0F)}) {
      looker.driver().resize(width, height);
      EXPECT_THAT(looker.driver().faults(), IsEmpty()) << scale << " " << width;
    }
  }
}

}  // namespace
}  // namespace hallux::ui
