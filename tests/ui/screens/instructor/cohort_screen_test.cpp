// A cohort at a glance, and one trainee of it.
#include "ui/screens/instructor/cohort_screen.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "tests/ui/screens/every_size.h"
#include "tests/ui/screens/some_navigator.h"
#include "tests/ui/screens/some_published.h"
#include "ui/screens/instructor/trainee_screen.h"
#include "ui/screens/parts/attempt_marks.h"
#include "ui/screens/parts/standing.h"
#include "ui/screens/trainee/history_screen.h"
#include "ui/screens/trainee/operations_screen.h"

namespace hallux::ui {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

struct Teacher {
  explicit Teacher(database::SomeCourse& course, const std::string& login = "kim",
                   float scale = 1.0F)
      : visitor(std::make_unique<CohortScreen>(visit_of(course, login), navigator,
                                               [this] { ++inbox_opened; }),
                scale) {}
  Driver& driver() { return visitor.driver(); }
  void press(std::string_view id) {
    driver().click(id);
    visitor.finish_work();
  }

  SomeNavigator navigator;
  int inbox_opened = 0;
  SomeVisitor visitor;
};

TEST(CohortScreen, ShowsHowEachTraineeStandsAndNobodyElse) {
  database::SomeCourse course;
  course.scored_by("ada", 61200);
  course.scored_by("ada", 87000);
  course.scored_by("eve", 33000);
  Teacher teacher(course);
  EXPECT_TRUE(teacher.driver().sees("autumn"));
  EXPECT_TRUE(teacher.driver().has("cohort.row.ada"));
  EXPECT_TRUE(teacher.driver().has("cohort.row.bob"));
  EXPECT_FALSE(teacher.driver().has("cohort.row.kim")) << "teaches it";
  EXPECT_TRUE(teacher.driver().sees("87")) << "the best";
  EXPECT_FALSE(shows_word(teacher.driver(), "eve"));
  EXPECT_FALSE(teacher.driver().sees("33"));
  EXPECT_THAT(teacher.driver().faults(), IsEmpty());
}

TEST(CohortScreen, ATraineeAnAttemptAndAQuestionLeadOn) {
  database::SomeCourse course;
  const database::AttemptId attempt = course.scored_by("ada", 61200);
  const auto request = course.trainee("ada").ask_for_help({attempt, {2000}, "Why?"});
  Teacher teacher(course);
  teacher.press("cohort.row.ada");
  teacher.press("cohort.attempt.1");
  teacher.press("cohort.request." + std::to_string(request.number));
  teacher.press("cohort.inbox");
  EXPECT_THAT(teacher.navigator.asked,
              ElementsAre("trainee " + std::to_string(course.id_of("ada").number) + " of " +
                              std::to_string(course.autumn().number),
                          "result " + attempt.text, "replay " + attempt.text + " at 0.002000"));
  EXPECT_EQ(teacher.inbox_opened, 1);
}

TEST(CohortScreen, PillsNarrowTheList) {
  database::SomeCourse course;
  course.scored_by("ada", 90000);
  course.scored_by("ada", 40000);
  const database::AttemptId attempt = course.scored_by("bob", 50000);
  course.trainee("bob").ask_for_help({attempt, {0}, "Why?"});
  Teacher teacher(course);
  const auto listed = [&] {
    std::string rows;
    for (const char* login : {"ada", "bob", "lee"})
      if (teacher.driver().has(std::string("cohort.row.") + login)) rows += login;
    return rows;
  };
  EXPECT_EQ(listed(), "adaboblee");
  teacher.press("cohort.filter.1");
  EXPECT_EQ(listed(), "bob") << "asks for help";
  teacher.press("cohort.filter.2");
  EXPECT_EQ(listed(), "ada") << "40 after 90";
  teacher.press("cohort.filter.3");
  EXPECT_EQ(listed(), "lee") << "never began";
  teacher.press("cohort.filter.0");
  EXPECT_EQ(listed(), "adaboblee");
}

TEST(CohortScreen, WhoTeachesSeveralChooses) {
  database::SomeCourse course;
  course.administrator().enrol(course.spring(), "kim", database::CohortRole::Instructor);
  Teacher teacher(course);
  EXPECT_TRUE(teacher.driver().has("cohort.row.ada"));
  press_by_keyboard(teacher.visitor, "cohort.other");
  teacher.driver().press(Key::Down);
  teacher.driver().press(Key::Enter);
  teacher.visitor.finish_work();
  EXPECT_TRUE(teacher.driver().has("cohort.row.eve"));
  EXPECT_FALSE(teacher.driver().has("cohort.row.ada"));
  Teacher of_one(course, "lee");
  EXPECT_FALSE(of_one.driver().has("cohort.other"));
}

TEST(CohortScreen, LimitsTheAssessmentsOfAnOperation) {
  database::SomeCourse course;
  Teacher teacher(course);
  teacher.press("cohort.limits");
  teacher.press("limits.row.silver");
  teacher.press("limits.number");
  teacher.driver().type("0");
  EXPECT_TRUE(teacher.driver().sees("A number from 1 to 1000, for example 3"));
  teacher.driver().press(Key::Backspace);
  teacher.driver().type("2");
  EXPECT_THAT(teacher.driver().faults(), IsEmpty());
  teacher.press("limits.act");
  EXPECT_TRUE(teacher.driver().sees("Silver: 2 assessments each in autumn"));
  ASSERT_EQ(course.instructor("kim", course.autumn()).limits().size(), 1U);
  EXPECT_EQ(course.instructor("kim", course.autumn()).limits()[0].attempts_max, 2);
  teacher.press("cohort.limits");
  teacher.press("limits.row.silver");
  teacher.press("limits.number");
  teacher.driver().press(Key::End);
  teacher.driver().press(Key::Backspace);
  teacher.press("limits.act");
  EXPECT_TRUE(teacher.driver().sees("Silver is not limited in autumn any more"));
  EXPECT_TRUE(course.instructor("kim", course.autumn()).limits().empty());
}

TEST(CohortScreen, SaysWhyALastAttemptDoesNotCount) {
  database::AttemptHeader attempt;
  attempt.state = database::AttemptState::Closed;
  attempt.begun.kind = database::AttemptKind::Assessment;
  std::string why;
  const Texts texts = english_texts();
  Driver driver(texts, [&](Ui& ui) { why = why_not_counted(ui, attempt); });
  EXPECT_EQ(why, "");
  attempt.begun.kind = database::AttemptKind::Practice;
  driver.frame();
  EXPECT_EQ(why, "Practice: it does not count towards competence");
  attempt.is_counted = false;
  driver.frame();
  EXPECT_EQ(why, "Imported from a directory that nobody accepted");
  attempt.is_valid = false;
  driver.frame();
  EXPECT_EQ(why, "Not valid for grading: its recording lost too much");
  attempt.state = database::AttemptState::Interrupted;
  driver.frame();
  EXPECT_EQ(why, "Interrupted: it was never finished");
  attempt.state = database::AttemptState::Void;
  driver.frame();
  EXPECT_EQ(why, "Void: an instructor set it aside");
}

TEST(CohortScreen, IsUsedByKeyboardAlone) {
  database::SomeCourse course;
  course.scored_by("bob", 50000);
  Teacher teacher(course);
  press_by_keyboard(teacher.visitor, "cohort.filter.3");
  press_by_keyboard(teacher.visitor, "cohort.filter.0");
  press_by_keyboard(teacher.visitor, "cohort.row.ada");
  teacher.driver().press(Key::Down);
  EXPECT_EQ(teacher.driver().focused(), "cohort.row.bob");
  teacher.driver().press(Key::Enter);
  press_by_keyboard(teacher.visitor, "cohort.attempt.1");
  EXPECT_EQ(teacher.navigator.asked.size(), 3U);
}

/// Twelve operations are published, Operation 01 to Operation 12; ada tried the last, bob none of
/// them.
struct ManyOperations {
  ManyOperations() {
    database::AdministratorDesk desk = course.administrator();
    for (int number = 1; number <= 12; ++number) {
      const std::string name = "operation_" + std::to_string(100 + number).substr(1);
      last = desk.import_scenario({name, 1, "{\"name\": \"" + name + "\"}", false});
      desk.publish_scenario(last);
    }
    database::NewAttempt attempt = course.attempt_of("ada");
    attempt.scenario = last;
    const database::AttemptId id =
        database::record(course.database(), attempt, database::some_recording(5));
    database::store_score(course.database(), id, database::card_worth(87'000), course.id_of("ada"));
  }

  database::SomeCourse course;
  database::ScenarioVersionId last;
};

/// A window of 1280 x 720 device pixels.
void shrink(SomeVisitor& visitor) {
  visitor.driver().resize(1280.0F, 720.0F);
  visitor.finish_work();
}

/// Every head that is seen while `turn` leads from page to page.
std::set<std::string> heads_seen(Teacher& teacher, const std::function<void()>& turn) {
  std::set<std::string> heads;
  for (int pages = 0; pages < 13; ++pages) {
    for (int number = 1; number <= 12; ++number) {
      const std::string head = "Operation " + std::to_string(100 + number).substr(1);
      if (teacher.driver().sees(head)) heads.insert(head);
    }
    EXPECT_TRUE(teacher.driver().has("cohort.row.ada")) << "the names stay";
    EXPECT_THAT(teacher.driver().faults(), IsEmpty()) << "page " << pages;
    if (teacher.driver().has("cohort.operations.on") &&
        teacher.driver().widget("cohort.operations.on").is_enabled) {
      turn();
    } else {
      break;
    }
  }
  return heads;
}

TEST(CohortScreen, OfManyOperationsAllAreReachedByMouse) {
  ManyOperations many;
  Teacher teacher(many.course, "kim", 2.0F);
  shrink(teacher.visitor);
  const auto heads = heads_seen(teacher, [&] { teacher.press("cohort.operations.on"); });
  EXPECT_EQ(heads.size(), 12U);
  EXPECT_TRUE(teacher.driver().sees("87")) << "what was reached in the last of them";
  teacher.press("cohort.operations.back");
  EXPECT_FALSE(teacher.driver().sees("Operation 12"));
}

TEST(CohortScreen, OfManyOperationsAllAreReachedByKeyboard) {
  ManyOperations many;
  Teacher teacher(many.course, "kim", 2.0F);
  shrink(teacher.visitor);
  const auto heads =
      heads_seen(teacher, [&] { press_by_keyboard(teacher.visitor, "cohort.operations.on"); });
  EXPECT_EQ(heads.size(), 12U);
  EXPECT_EQ(teacher.driver().focused(), "cohort.operations.on")
      << "and is told that it is the last";
}

TEST(CohortScreen, ALongNameLeavesRoomForThreeOperationsAndIsSaidWhole) {
  ManyOperations many;
  database::AdministratorDesk desk = many.course.administrator();
  const std::string name = "a_distal_chevron_osteotomy_of_the_first_metatarsal";
  desk.publish_scenario(desk.import_scenario({name, 1, "{\"name\": \"" + name + "\"}", false}));
  const std::string whole = "A distal chevron osteotomy of the first metatarsal";
  for (const float scale : {1.0F, 1.5F, 2.0F}) {
    Teacher teacher(many.course, "kim", scale);
    shrink(teacher.visitor);
    Driver& driver = teacher.driver();
    int heads = 0;
    for (int column = 1; column <= 13; ++column)
      heads += driver.has("cohort.row.sort." + std::to_string(column)) ? 1 : 0;
    EXPECT_GE(heads, 3) << scale;
    EXPECT_THAT(driver.faults(), IsEmpty()) << scale;
    const Rect head = driver.widget("cohort.row.sort.1").rect;
    driver.move_to(head.centre());
    driver.wait(1.0);
    EXPECT_THAT(driver.texts(), testing::Contains(whole)) << scale;
    EXPECT_THAT(driver.faults(), IsEmpty()) << scale;
    driver.move_to({2.0F, 2.0F});
    driver.wait(1.0);
    press_by_keyboard(teacher.visitor, "cohort.row.sort.1");
    EXPECT_THAT(driver.texts(), testing::Contains(whole)) << scale;
  }
}

TEST(CohortScreen, AnOperationOfALaterPageSortsAndKeepsSorting) {
  ManyOperations many;
  Teacher teacher(many.course);
  const auto is_ada_first = [&] {
    return teacher.driver().widget("cohort.row.ada").rect.y <
           teacher.driver().widget("cohort.row.bob").rect.y;
  };
  ASSERT_TRUE(is_ada_first());
  while (teacher.driver().widget("cohort.operations.on").is_enabled)
    teacher.press("cohort.operations.on");
  teacher.press("cohort.row.sort.12");
  EXPECT_FALSE(is_ada_first()) << "the least first";
  while (teacher.driver().widget("cohort.operations.back").is_enabled)
    teacher.press("cohort.operations.back");
  EXPECT_FALSE(is_ada_first()) << "also where its column is not on the page";
  teacher.press("cohort.row.sort.0");
  EXPECT_TRUE(is_ada_first());
}

TEST(CohortScreen, OfManyOperationsNothingIsCutOffAnywhere) {
  ManyOperations many;
  SomeNavigator navigator;
  EXPECT_THAT(faults_at_every_size([&] {
                return std::make_unique<CohortScreen>(visit_of(many.course, "kim"), navigator,
                                                      [] {});
              }),
              IsEmpty());
}

TEST(CohortScreen, WhoDoesNotTeachItAnyMoreSeesWhy) {
  database::SomeCourse course;
  SomeNavigator navigator;
  const std::shared_ptr<SignedInSession> signed_in = visit_of(course, "kim");
  course.administrator().remove_from_cohort(course.autumn(), "kim");
  SomeVisitor visitor(std::make_unique<CohortScreen>(signed_in, navigator));
  EXPECT_TRUE(visitor.driver().sees("You do not teach this cohort any more"));
  EXPECT_FALSE(visitor.driver().sees("ada"));
}

TEST(CohortScreen, NothingIsCutOffAnywhere) {
  database::SomeCourse course;
  course.scored_by("ada", 90000);
  const database::AttemptId attempt = course.scored_by("ada", 40000);
  course.trainee("ada").ask_for_help({attempt, {0}, "Why did I lose so many points at once here?"});
  SomeNavigator navigator;
  EXPECT_THAT(faults_at_every_size([&] {
                return std::make_unique<CohortScreen>(visit_of(course, "kim"), navigator, [] {});
              }),
              IsEmpty());
  EXPECT_THAT(faults_at_every_size([&] {
                return std::make_unique<CohortScreen>(visit_of(course, "lee"), navigator, [] {});
              }),
              IsEmpty())
      << "with nothing to show";
}

const std::string now = "2026-03-03T10:00:00Z";

database::OperationStanding tried_twice() {
  database::OperationStanding standing;
  standing.scenario_name = "akin";
  standing.attempts = 2;
  standing.best_milli = 80'000;
  standing.last_milli = 60'001;
  standing.last_started_utc = "2026-03-01T10:00:00Z";
  return standing;
}

TEST(Standing, SaysWhatTheResultsSay) {
  const assessment::LearningState nothing;
  EXPECT_EQ(competence_of({}, nothing, now), Competence::NotStarted);
  database::OperationStanding standing = tried_twice();
  EXPECT_EQ(competence_of(standing, nothing, now), Competence::Learning);
  standing.last_milli = 60'000;
  EXPECT_EQ(competence_of(standing, nothing, now), Competence::Slipped);
  standing.last_started_utc = "2025-12-03T10:00:00Z";  // 90 days
  EXPECT_EQ(competence_of(standing, nothing, now), Competence::Slipped);
  standing.last_started_utc = "2025-12-02T10:00:00Z";
  EXPECT_EQ(competence_of(standing, nothing, now), Competence::Stale);
}

TEST(Standing, SaysWhatTheAssessmentsSayBeforeAllElse) {
  database::OperationStanding standing = tried_twice();
  std::vector<bool> passed(12, true);
  EXPECT_EQ(competence_of(standing, assessment::learning_state(passed), now),
            Competence::Competent);
  standing.last_milli = 10'000;
  EXPECT_EQ(competence_of(standing, assessment::learning_state(passed), now), Competence::Competent)
      << "one bad result takes nothing back";
  passed.insert(passed.end(), 3, false);
  standing.last_milli = standing.best_milli;
  EXPECT_EQ(competence_of(standing, assessment::learning_state(passed), now), Competence::Slipped);
}

TEST(Standing, TheRingFillsWithTheEvidence) {
  EXPECT_FLOAT_EQ(progress_of(tried_twice(), {}), 0.8F) << "no assessment counts yet";
  const auto half = assessment::learning_state(std::vector<bool>(6, true));
  EXPECT_NEAR(progress_of(tried_twice(), half), 0.5F, 0.01F);
}

/// The same attempts, as the instructor and as the trainee see them.
struct BothSides {
  explicit BothSides(SomePublished& published) {
    database::InstructorDesk desk =
        published.course().instructor("kim", published.course().autumn());
    for (const TraineeProgress& each : trainees_of(desk)) {
      if (each.standing.login != "ada") continue;
      grid = competence_of(each.standing.operations.front(), each.learning.front(), now);
      page = progress_in(desk.trainee(each.standing.id)).learning.front().is_competent;
    }
    database::Session session = published.course().sign_in_as("ada");
    history = histories_of(own_attempts(session)).front().learning.is_competent;
    for (const OwnOperation& each : own_operations(session, published.course().database()))
      if (each.published.name == "akin") choice = competence_of(each, now);
  }

  Competence grid = Competence::NotStarted, choice = Competence::NotStarted;
  bool page = false, history = false;
};

TEST(Standing, InstructorAndTraineeSeeTheSame) {
  SomePublished published;
  published.assessed("ada", 11, 60000);
  const BothSides before(published);
  EXPECT_EQ(before.grid, Competence::Learning);
  EXPECT_EQ(before.choice, Competence::Learning);
  EXPECT_FALSE(before.page || before.history);
  published.assessed("ada", 1, 60000);
  const BothSides after(published);
  EXPECT_EQ(after.grid, Competence::Competent);
  EXPECT_EQ(after.choice, Competence::Competent);
  EXPECT_TRUE(after.page && after.history);
}

TEST(CohortScreen, WhoWasCompetentAndFailedAgainAndAgainHasSlipped) {
  SomePublished published;
  published.assessed("ada", 12, 60000);
  published.assessed("bob", 12, 60000);
  published.assessed("ada", 3, 59000);  // not far below the best, but three in a row
  Teacher teacher(published.course());
  teacher.press("cohort.filter.2");
  EXPECT_TRUE(teacher.driver().has("cohort.row.ada"));
  EXPECT_FALSE(teacher.driver().has("cohort.row.bob"));
}

TEST(TraineeScreen, SaysCompetentWhereTheAssessmentsDo) {
  SomePublished published;
  published.assessed("ada", 12, 60000);
  SomeNavigator navigator;
  database::SomeCourse& course = published.course();
  SomeVisitor visitor(std::make_unique<TraineeScreen>(visit_of(course, "kim"), navigator,
                                                      course.autumn(), course.id_of("ada")));
  EXPECT_TRUE(visitor.driver().sees("Competent"));
}

TEST(TraineeScreen, ShowsStandingAndAttemptsNewestFirst) {
  database::SomeCourse course;
  course.scored_by("ada", 61200);
  const database::AttemptId newest = course.scored_by("ada", 40000);
  SomeNavigator navigator;
  SomeVisitor visitor(std::make_unique<TraineeScreen>(visit_of(course, "kim"), navigator,
                                                      course.autumn(), course.id_of("ada")));
  EXPECT_TRUE(visitor.driver().sees("Best 61.2, last 40.0"));
  EXPECT_TRUE(visitor.driver().sees("Slipped"));
  EXPECT_LT(visitor.driver().widget("trainee.row.2").rect.y,
            visitor.driver().widget("trainee.row.1").rect.y);
  EXPECT_FALSE(visitor.driver().sees("bob"));
  press_by_keyboard(visitor, "trainee.row.2");
  EXPECT_THAT(navigator.asked, ElementsAre("result " + newest.text));
}

TEST(TraineeScreen, SaysWhichAttemptsDoNotCount) {
  SomePublished published;
  database::SomeCourse& course = published.course();
  const auto shown = [&] {
    SomeNavigator navigator;
    SomeVisitor visitor(std::make_unique<TraineeScreen>(visit_of(course, "kim"), navigator,
                                                        course.autumn(), course.id_of("ada")));
    return std::pair(visitor.driver().sees("Does not count"), visitor.driver().sees("Advisory"));
  };
  published.scored_by("ada", 40000);
  EXPECT_EQ(shown(), std::pair(true, false));
  published.assessed("ada", 1, 50000);
  EXPECT_EQ(shown(), std::pair(true, true));
}

TEST(TraineeScreen, ShowsNobodyOfAnotherCohort) {
  database::SomeCourse course;
  course.scored_by("eve", 61200);
  SomeNavigator navigator;
  SomeVisitor visitor(std::make_unique<TraineeScreen>(visit_of(course, "kim"), navigator,
                                                      course.autumn(), course.id_of("eve")));
  EXPECT_TRUE(visitor.driver().sees("This could not be read"));
  EXPECT_FALSE(visitor.driver().sees("61.2"));
}

TEST(TraineeScreen, GoesBackByItsButton) {
  database::SomeCourse course;
  SomeNavigator navigator;
  const std::shared_ptr<SignedInSession> signed_in = visit_of(course, "kim");
  SomeVisitor visitor(std::make_unique<CohortScreen>(signed_in, navigator));
  visitor.shell().push(
      std::make_unique<TraineeScreen>(signed_in, navigator, course.autumn(), course.id_of("ada")));
  visitor.driver().frame();
  visitor.finish_work();
  EXPECT_TRUE(visitor.driver().sees("No attempts yet"));
  visitor.driver().click("trainee.back");
  visitor.finish_work();
  EXPECT_EQ(visitor.shell().depth(), 1U);
  EXPECT_TRUE(visitor.driver().has("cohort.row.ada"));
}

TEST(TraineeScreen, NothingIsCutOffAnywhere) {
  database::SomeCourse course;
  course.scored_by("ada", 61200);
  course.interrupted_of("ada");
  SomeNavigator navigator;
  EXPECT_THAT(faults_at_every_size([&] {
                return std::make_unique<TraineeScreen>(visit_of(course, "kim"), navigator,
                                                       course.autumn(), course.id_of("ada"));
              }),
              IsEmpty());
}

}  // namespace
}  // namespace hallux::ui
