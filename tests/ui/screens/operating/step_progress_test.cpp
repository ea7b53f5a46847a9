#include "ui/screens/operating/step_progress.h"

#include <gtest/gtest.h>

#include "tests/ui/screens/operating/led_operation.h"

namespace hallux::ui {
namespace {

using scenarios::StepKind;
using scenarios::WantedPart;
using simulator::CutEventKind;

/// Free as the kernel said it, in this order.
void free_pieces(StepProgress& steps, const std::vector<std::int32_t>& pieces) {
  for (const std::int32_t piece : pieces)
    EXPECT_FALSE(steps.apply(event_of(CutEventKind::PieceFreed, piece)).is_fulfilled);
}

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

TEST(StepProgress, APieceIsTakenOutOnceItIsOff) {
  StepProgress steps({StepKind::Remove, StepKind::Remove});
  EXPECT_FALSE(steps.is_ready());
  free_pieces(steps, {1});
  steps.see(std::vector<WantedPart>{{{1}, true}, {}});
  EXPECT_TRUE(steps.is_ready());
  EXPECT_EQ(steps.press(0.0), StepDeed::PickUp);
  EXPECT_EQ(steps.piece_to_take(), 1);
  EXPECT_TRUE(steps.is_waiting());
  EXPECT_FALSE(steps.is_ready());
  EXPECT_TRUE(steps.apply(event_of(CutEventKind::PieceRemoved, 1)).is_fulfilled);
  EXPECT_EQ(steps.end_step(), 0);
  EXPECT_FALSE(steps.is_waiting());
  EXPECT_FALSE(steps.is_ready()) << "the part of the next step is not off yet";
}

TEST(StepProgress, ACrumbAloneIsNoReasonToTakeAnythingOut) {
  StepProgress steps({StepKind::Remove});
  free_pieces(steps, {1});
  steps.see(std::vector<WantedPart>{{{1}, false}});
  EXPECT_TRUE(steps.lies_anything_free());
  EXPECT_FALSE(steps.is_ready());
  EXPECT_EQ(steps.press(0.0), StepDeed::Nothing);
  EXPECT_FALSE(steps.is_waiting());
}

TEST(StepProgress, WhatBrokeOffThePieceGoesWithItHoweverTheyCameFree) {
  for (const std::vector<std::int32_t>& freed : {std::vector{2, 5}, std::vector{5, 2}}) {
    StepProgress steps({StepKind::Remove, StepKind::Finish});
    free_pieces(steps, freed);
    steps.see(std::vector<WantedPart>{{{5, 2}, true}});
    EXPECT_EQ(steps.press(0.0), StepDeed::PickUp);
    EXPECT_EQ(steps.piece_to_take(), 5) << "the largest first";
    const StepNews news = steps.apply(event_of(CutEventKind::PieceRemoved, 5));
    EXPECT_FALSE(news.is_fulfilled) << "a crumb of it still lies there";
    EXPECT_EQ(news.piece, 2);
    EXPECT_TRUE(steps.apply(event_of(CutEventKind::PieceRemoved, 2)).is_fulfilled);
  }
}

TEST(StepProgress, APieceThatNobodyAskedForEndsNoStep) {
  StepProgress steps({StepKind::Remove});
  free_pieces(steps, {1, 2});
  steps.see(std::vector<WantedPart>{{{2}, true}});
  steps.press(0.0);
  EXPECT_FALSE(steps.apply(event_of(CutEventKind::PieceRemoved, 1)).is_fulfilled);
  EXPECT_TRUE(steps.apply(event_of(CutEventKind::PieceRemoved, 2)).is_fulfilled);
}

TEST(StepProgress, AsksForNoMorePiecesThanAnAttemptMayTakeOut) {
  StepProgress steps({StepKind::Remove});
  const std::vector<std::int32_t> pieces{1, 2, 3, 4, 5, 6, 7, 8, 9, 10};
  free_pieces(steps, pieces);
  steps.see(std::vector<WantedPart>{{pieces, true}});
  steps.press(0.0);
  for (std::int32_t piece = 1; piece < 8; ++piece)
    EXPECT_EQ(steps.apply(event_of(CutEventKind::PieceRemoved, piece)).piece, piece + 1);
  EXPECT_TRUE(steps.apply(event_of(CutEventKind::PieceRemoved, 8)).is_fulfilled);
}

TEST(StepProgress, WhereAllOfThePartIsOutTheStepOnlyEnds) {
  StepProgress steps({StepKind::Remove});
  steps.see(std::vector<WantedPart>{{{}, true}});
  EXPECT_TRUE(steps.is_ready());
  EXPECT_EQ(steps.press(0.0), StepDeed::EndStep);
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
  EXPECT_EQ(told(CutEventKind::HingeRefused, 1), Notice::HingeBroken);
  EXPECT_EQ(told(CutEventKind::HingeRefused, 2), Notice::HingeStiff);
  EXPECT_EQ(told(CutEventKind::HingeRefused, 3), Notice::HingeMissing);
  EXPECT_EQ(told(CutEventKind::KerfRefused, 0), Notice::KerfRefused);
}

TEST(StepProgress, WaitsTwentySecondsForAnAnswer) {
  StepProgress steps({StepKind::Close});
  steps.press(5.0);
  EXPECT_FALSE(steps.expire(24.9).has_value());
  EXPECT_EQ(steps.expire(25.0), Notice::HingeUnanswered);
  EXPECT_FALSE(steps.expire(26.0).has_value());
  EXPECT_TRUE(steps.is_ready());
}

// -- steps that only say what they come after

scenarios::Scenario in_any_order() {
  scenarios::Scenario scenario;
  scenario.format = 2;
  const auto step = [](const char* id, StepKind kind, std::vector<std::string> after) {
    scenarios::OperationStep made;
    made.id = id;
    made.kind = kind;
    made.after = std::move(after);
    return made;
  };
  scenario.steps = {step("verify", StepKind::Verify, {}),
                    step("hold", StepKind::Retract, {"verify"}),
                    step("one", StepKind::Cut, {"verify", "hold"}),
                    step("other", StepKind::Cut, {"verify", "hold"}),
                    step("finish", StepKind::Finish, {"one", "other"})};
  scenario.steps[1].is_optional = true;
  return scenario;
}

TEST(StepProgress, OfSeveralThatMayBeDoneNextAnotherIsChosen) {
  const scenarios::Scenario scenario = in_any_order();
  StepProgress steps(scenario);
  EXPECT_FALSE(steps.can_choose(1)) << "nothing comes before the first";
  steps.end_step();
  EXPECT_EQ(steps.step(), 1U);
  EXPECT_TRUE(steps.can_choose(2)) << "the optional one may be passed over";
  EXPECT_TRUE(steps.can_choose(3));
  EXPECT_FALSE(steps.can_choose(4));
  steps.choose(3);
  EXPECT_EQ(steps.end_step(), 3);
  EXPECT_EQ(steps.step(), 2U);
  EXPECT_FALSE(steps.can_choose(1)) << "it was passed over";
  EXPECT_EQ(steps.end_step(), 2);
  EXPECT_EQ(steps.kind(), StepKind::Finish);
}

TEST(StepProgress, AfterAStepThatWasTakenUpAgainComesTheNextThatMayBeDone) {
  const scenarios::Scenario scenario = in_any_order();
  StepProgress steps(scenario);
  for (int i = 0; i < 3; ++i) steps.end_step();
  EXPECT_EQ(steps.step(), 3U);
  EXPECT_TRUE(steps.can_reopen(1));
  steps.reopen(1);
  EXPECT_EQ(steps.step(), 1U);
  steps.end_step();
  EXPECT_EQ(steps.step(), 3U);
}

TEST(StepProgress, WhatIsTrimmedIsTakenOutOrEndsUnfinished) {
  StepProgress steps({StepKind::Trim, StepKind::Trim});
  EXPECT_TRUE(steps.is_ready());
  EXPECT_EQ(steps.press(0.0), StepDeed::EndStep);
  steps.end_step();
  free_pieces(steps, {2});
  steps.see(std::vector<WantedPart>{{}, {{2}, true}});
  EXPECT_EQ(steps.press(1.0), StepDeed::PickUp);
  EXPECT_TRUE(steps.apply(event_of(CutEventKind::PieceRemoved, 2)).is_fulfilled);
}

}  // namespace
}  // namespace hallux::ui
