#include "ui/screens/operating/step_progress.h"

#include <gtest/gtest.h>

#include "tests/ui/screens/operating/led_operation.h"

namespace hallux::ui {
namespace {

using scenarios::StepKind;
using simulator::CutEventKind;

TEST(StepProgress, ADeclaredStepIsDoneAtOnce) {
  StepProgress steps({StepKind::Verify, StepKind::Cut});
  EXPECT_EQ(steps.press(0.0), StepDeed::EndStep);
  EXPECT_EQ(steps.end_step(), 0);
  EXPECT_EQ(steps.kind(), StepKind::Cut);
  EXPECT_EQ(steps.end_step(), 1);
  EXPECT_FALSE(steps.kind().has_value());
  EXPECT_FALSE(steps.is_ready());
  EXPECT_EQ(steps.press(0.0), StepDeed::Nothing) << "there is no step left";
}

TEST(StepProgress, APieceIsTakenOutOnceOneIsFree) {
  StepProgress steps({StepKind::Remove, StepKind::Remove});
  EXPECT_FALSE(steps.is_ready());
  steps.apply(event_of(CutEventKind::PieceFreed));
  EXPECT_TRUE(steps.is_ready());
  EXPECT_EQ(steps.press(0.0), StepDeed::PickUp);
  EXPECT_TRUE(steps.is_waiting());
  EXPECT_FALSE(steps.is_ready());
  EXPECT_TRUE(steps.apply(event_of(CutEventKind::PieceRemoved)).is_fulfilled);
  EXPECT_EQ(steps.end_step(), 0);
  EXPECT_FALSE(steps.is_waiting());
  EXPECT_FALSE(steps.is_ready()) << "the next piece is not free yet";
}

TEST(StepProgress, AnAnswerThatNobodyWaitsForEndsNothing) {
  StepProgress steps({StepKind::Close});
  EXPECT_FALSE(steps.apply(event_of(CutEventKind::HingeClosed)).is_fulfilled);
  EXPECT_EQ(steps.press(0.0), StepDeed::CloseHinge);
  EXPECT_FALSE(steps.apply(event_of(CutEventKind::PieceRemoved)).is_fulfilled);
  EXPECT_TRUE(steps.apply(event_of(CutEventKind::HingeClosed)).is_fulfilled);
}

TEST(StepProgress, ARefusalIsToldAndTheStepIsAtHandAgain) {
  const auto told = [](CutEventKind kind, std::int32_t subject) {
    StepProgress steps({StepKind::Close});
    steps.press(0.0);
    const StepNews news = steps.apply(event_of(kind, subject));
    EXPECT_FALSE(news.is_fulfilled);
    EXPECT_TRUE(steps.is_ready());
    return news.notice;
  };
  EXPECT_EQ(told(CutEventKind::HingeRefused, 1), StepNotice::HingeBroken);
  EXPECT_EQ(told(CutEventKind::HingeRefused, 2), StepNotice::HingeStiff);
  EXPECT_EQ(told(CutEventKind::HingeRefused, 3), StepNotice::HingeMissing);
  EXPECT_EQ(told(CutEventKind::KerfRefused, 0), StepNotice::KerfRefused);
}

TEST(StepProgress, WaitsTwentySecondsForAnAnswer) {
  StepProgress steps({StepKind::Close});
  steps.press(5.0);
  EXPECT_FALSE(steps.expire(24.9).has_value());
  EXPECT_EQ(steps.expire(25.0), StepNotice::HingeUnanswered);
  EXPECT_FALSE(steps.expire(26.0).has_value());
  EXPECT_TRUE(steps.is_ready());
}

}  // namespace
}  // namespace hallux::ui
