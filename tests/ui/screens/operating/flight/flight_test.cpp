// The whole first flight in virtual time, flown by a hand that only obeys: it knows the lesson's
// hint and nothing else.
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <string>

#include "scenarios/practice_block.h"
#include "tests/ui/screens/operating/obedient_hand.h"
#include "ui/screens/operating/flight/lesson_deeds.h"

namespace hallux::ui {
namespace {

using scenarios::StepKind;

constexpr double a_minute_s = 60.0;
/// Long enough for anybody who was told what to do.
constexpr double patience_s = 120.0;

PreparedCase block_case() {
  scenarios::PracticeBlock block = scenarios::make_practice_block();
  return prepare_case(std::move(block.scenario), std::move(block.bone));
}

std::string name_of(const testing::TestParamInfo<Lesson>& lesson) {
  constexpr std::array<const char*, lesson_count> names{
      "Look", "Approach", "Start", "Stroke", "Withdraw", "SecondPass", "TakeOut"};
  return names[static_cast<std::size_t>(lesson.param)];
}

/// Somebody in their first flight.
class Flight {
 public:
  LessonView view() const {
    return lesson_view(operation.sources(), sawing_, world_from_first_view_);
  }
  /// Ends the lessons whose deed is done.
  void look() {
    while (!lessons.are_over() && is_done(lessons.at_hand(), view())) lessons.end(LessonEnd::Done);
  }
  /// Obeys until all lessons are over, but for the one whose hint is blanked.
  void fly(std::optional<Lesson> blanked = std::nullopt) {
    for (look(); !lessons.are_over() && operation.time_s() < patience_s; look()) {
      if (lessons.at_hand() == skipped) {
        lessons.end(LessonEnd::Skipped);
        continue;
      }
      const std::optional<Hint> hint = lesson_hint(lessons.at_hand(), view());
      if (hint && lessons.at_hand() != blanked) {
        obey(operation, *hint);
      } else {
        operation.advance(ticks_per_look);
      }
    }
  }

  VirtualOperation operation{block_case(), StepProgress({StepKind::Remove}),
                             database::AttemptKind::Practice};
  FlightLessons lessons;
  std::optional<Lesson> skipped;

 private:
  StepProgress sawing_{{StepKind::Cut}};
  Quat world_from_first_view_ = operation.world_from_view;
};

TEST(FirstFlight, AHandThatOnlyObeysFliesItWithinAMinute) {
  Flight flight;
  flight.fly();
  EXPECT_TRUE(flight.lessons.are_over()) << "stands at " << flight.lessons.number();
  EXPECT_LT(flight.operation.time_s(), a_minute_s);
  for (std::size_t number = 0; number < lesson_count; ++number)
    EXPECT_EQ(flight.lessons.end_of(static_cast<Lesson>(number)), LessonEnd::Done) << number;
  EXPECT_EQ(std::ranges::count(flight.operation.events(), simulator::CutEventKind::PieceRemoved,
                               &simulator::CutEvent::kind),
            1);
}

TEST(FirstFlight, WhoeverLooksSquarelyAtThePlaneIsToldToTurnTheView) {
  Flight flight;
  flight.skipped = Lesson::Look;
  // Along the plane's normal: nothing that moves on the screen changes the offset.
  flight.operation.world_from_view = rotation_from_axes(Vec3(0.0, 0.0, -1.0), Vec3(0.0, 1.0, 0.0));
  flight.fly();
  EXPECT_TRUE(flight.lessons.are_over()) << "stands at " << flight.lessons.number();
}

TEST(FirstFlight, OneStrokeLeavesASecondPassToDo) {
  Flight flight;
  bool has_withdrawn = false;
  for (flight.look(); !has_withdrawn && flight.operation.time_s() < patience_s; flight.look()) {
    has_withdrawn = flight.lessons.end_of(Lesson::Withdraw) == LessonEnd::Done;
    if (const std::optional<Hint> hint = lesson_hint(flight.lessons.at_hand(), flight.view()))
      obey(flight.operation, *hint);
  }
  ASSERT_TRUE(has_withdrawn);
  const double held = flight.operation.site()->cuts.front().share;
  EXPECT_GT(held, 0.2);
  EXPECT_LT(held, 0.6);
}

class EachLesson : public testing::TestWithParam<Lesson> {};

TEST_P(EachLesson, IsPassedByNobodyWhoIsNotTold) {
  Flight flight;
  flight.fly(GetParam());
  ASSERT_FALSE(flight.lessons.are_over());
  EXPECT_EQ(flight.lessons.at_hand(), GetParam());
}

TEST_P(EachLesson, CanBeLeftOutAndTheOthersAreFlown) {
  Flight flight;
  flight.skipped = GetParam();
  flight.fly();
  EXPECT_TRUE(flight.lessons.are_over()) << "stands at " << flight.lessons.number();
  for (std::size_t number = 0; number < lesson_count; ++number) {
    const auto lesson = static_cast<Lesson>(number);
    EXPECT_EQ(flight.lessons.end_of(lesson),
              lesson == GetParam() ? LessonEnd::Skipped : LessonEnd::Done)
        << number;
  }
}

INSTANTIATE_TEST_SUITE_P(FirstFlight, EachLesson,
                         testing::Values(Lesson::Look, Lesson::Approach, Lesson::Start,
                                         Lesson::Stroke, Lesson::Withdraw, Lesson::SecondPass,
                                         Lesson::TakeOut),
                         name_of);

}  // namespace
}  // namespace hallux::ui
