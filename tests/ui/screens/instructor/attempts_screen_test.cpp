#include "ui/screens/instructor/attempts_screen.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/database/some_course.h"
#include "tests/ui/screens/some_navigator.h"
#include "tests/ui/screens/some_visitor.h"

namespace hallux::ui {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// A person of a course who looks at their attempts.
struct Reader {
  Reader(database::SomeCourse& course, const std::string& login, float scale = 1.0F)
      : visitor(std::make_unique<AttemptsScreen>(visit_of(course, login), navigator), scale) {}
  Driver& driver() { return visitor.driver(); }

  SomeNavigator navigator;
  SomeVisitor visitor;
};

TEST(AttemptsScreen, SaysWhereThereAreNone) {
  database::SomeCourse course;
  Reader reader(course, "eve");
  EXPECT_TRUE(reader.driver().sees("No attempts yet"));
  EXPECT_THAT(reader.driver().faults(), IsEmpty());
}

TEST(AttemptsScreen, TraineesSeeTheirOwnAndNobodyElses) {
  database::SomeCourse course;
  course.scored_by("ada", 76830);
  course.scored_by("bob", 31250);
  Reader reader(course, "ada");
  EXPECT_TRUE(reader.driver().sees("76.8"));
  EXPECT_FALSE(reader.driver().sees("31.3"));
  EXPECT_FALSE(reader.driver().sees("bob"));
}

TEST(AttemptsScreen, InstructorsSeeTheirCohorts) {
  database::SomeCourse course;
  course.scored_by("ada", 76830);
  course.scored_by("eve", 31250);
  Reader reader(course, "kim");
  EXPECT_TRUE(reader.driver().sees("ada"));
  EXPECT_FALSE(reader.driver().sees("eve"));
}

TEST(AttemptsScreen, TheScoresHeadSortsThem) {
  database::SomeCourse course;
  course.scored_by("ada", 31250);
  course.scored_by("ada", 76830);
  Reader reader(course, "ada");
  const auto first_of = [&](const char* a, const char* b) {
    for (const std::string& text : reader.driver().texts()) {
      if (text == a || text == b) return text;
    }
    return std::string();
  };
  EXPECT_EQ(first_of("31.3", "76.8"), "76.8") << "newest first";
  reader.driver().click("attempts.sort.6");
  EXPECT_EQ(first_of("31.3", "76.8"), "31.3");
  reader.driver().click("attempts.sort.6");
  EXPECT_EQ(first_of("31.3", "76.8"), "76.8");
}

TEST(AttemptsScreen, ARowLeadsToItsResult) {
  database::SomeCourse course;
  const database::AttemptId attempt = course.scored_by("ada", 76830);
  Reader reader(course, "ada");
  reader.driver().click("attempts.1");
  EXPECT_THAT(reader.navigator.asked, ElementsAre("result " + attempt.text));
}

TEST(AttemptsScreen, APracticeDoesNotCountForTraineesAndInstructors) {
  database::SomeCourse course;
  course.scored_by("ada", 76830);
  for (const char* login : {"ada", "kim"}) {
    Reader reader(course, login);
    EXPECT_TRUE(reader.driver().sees("Does not count")) << login;
    EXPECT_FALSE(reader.driver().sees("Advisory")) << login;
  }
}

TEST(AttemptsScreen, EveryStateIsShownAndNothingIsCutOff) {
  database::SomeCourse course;
  course.scored_by("ada", 76830);
  course.interrupted_of("ada");
  course.recorded_by("ada");
  for (const float scale : {0.8F, 1.0F, 1.5F, 2.0F}) {
    Reader reader(course, "ada", scale);
    EXPECT_TRUE(reader.driver().sees("Interrupted"));
    EXPECT_TRUE(reader.driver().sees("Not scored"));
    EXPECT_THAT(reader.driver().faults(), IsEmpty()) << scale;
    reader.driver().resize(1280.0F, 720.0F);
    reader.driver().settle();
    EXPECT_TRUE(reader.driver().sees("76.8")) << "however narrow";
    EXPECT_THAT(reader.driver().faults(), IsEmpty()) << "1280 x 720 at " << scale;
  }
}

}  // namespace
}  // namespace hallux::ui
