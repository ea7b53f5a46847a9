// What a result says where there is no score, or where one does not count; and that its head stays.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/ui/screens/result/some_reader.h"

namespace hallux::ui {
namespace {

using database::SomeCourse;
using testing::IsEmpty;

TEST(ResultScreen, AnInterruptedAttemptSaysSo) {
  SomeCourse course;
  Reader reader(course, "ada", course.interrupted_of("ada"));
  EXPECT_TRUE(reader.driver().sees("Interrupted"));
  EXPECT_TRUE(reader.driver().sees("Not scored"));
  EXPECT_TRUE(reader.driver().sees("Only an attempt that was finished has a score"));
  EXPECT_TRUE(reader.driver().sees("it is not scored, and counts for nothing"));
  for (const char* untrue :
       {"Not scored yet", "Computed now", "appears as soon as", "when the attempt"})
    EXPECT_FALSE(reader.driver().sees(untrue)) << untrue;
  EXPECT_THAT(reader.driver().faults(), IsEmpty());
}

TEST(ResultScreen, APracticeSaysThatItDoesNotCount) {
  SomeCourse course;
  Reader reader(course, "ada", course.scored_by("ada", 50'000));
  EXPECT_TRUE(reader.driver().sees("Practice: does not count"));
}

TEST(ResultScreen, TheHeadStaysAndTheWheelOverTheLedgerScrollsThePage) {
  OperatedCourse akin;
  Reader reader(akin.course, "ada", akin.attempt);
  Driver& driver = reader.driver();
  driver.resize(1280.0F, 720.0F);
  const Rect replay = driver.widget("result.replay").visible;
  const auto top_of = [&](std::string_view id) { return driver.widget(id).rect.y; };
  for (int turn = 0; turn < 6; ++turn) driver.wheel({700.0F, 600.0F}, -1.0F);
  const Rect ledger = driver.widget("result.ledger.rows").visible;
  const float before = top_of("result.ledger.rows");
  for (int turn = 0; turn < 60; ++turn) driver.wheel(ledger.centre(), 1.0F);
  EXPECT_GT(top_of("result.ledger.rows"), before) << "upwards, past the ledger's own beginning";
  EXPECT_EQ(driver.widget("result.replay").visible, replay);
  EXPECT_EQ(driver.widget("result.replay").visible.h, replay.h);
}

}  // namespace
}  // namespace hallux::ui
