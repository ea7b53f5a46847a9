#include "ui/screens/operating/flight/flight_lessons.h"

#include <gtest/gtest.h>

namespace hallux::ui {
namespace {

TEST(FlightLessons, ComeOneAfterTheOtherUntilTheyAreOver) {
  FlightLessons lessons;
  for (std::size_t number = 0; number < lesson_count; ++number) {
    ASSERT_FALSE(lessons.are_over());
    EXPECT_EQ(lessons.at_hand(), static_cast<Lesson>(number));
    lessons.end(number % 2 == 0 ? LessonEnd::Done : LessonEnd::Skipped);
  }
  EXPECT_TRUE(lessons.are_over());
  EXPECT_EQ(lessons.end_of(Lesson::Look), LessonEnd::Done);
  EXPECT_EQ(lessons.end_of(Lesson::Approach), LessonEnd::Skipped);
}

TEST(FlightLessons, OnAnUncutBlockWhoeverLookedNeedNotLookAgain) {
  FlightLessons lessons;
  lessons.begin_again();
  EXPECT_EQ(lessons.at_hand(), Lesson::Look);
  for (int ended = 0; ended < 4; ++ended) lessons.end(LessonEnd::Done);
  lessons.begin_again();
  EXPECT_EQ(lessons.at_hand(), Lesson::Approach);
  EXPECT_EQ(lessons.end_of(Lesson::Look), LessonEnd::Done);
  EXPECT_EQ(lessons.end_of(Lesson::Stroke), LessonEnd::Open);
}

}  // namespace
}  // namespace hallux::ui
