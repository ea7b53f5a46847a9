#include "assessment/process/step_order.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/assessment/examined_attempt.h"

namespace hallux::assessment {
namespace {

using scenarios::StepKind;
using simulator::CutEventKind;
using testing::examined;
using testing::ExaminedAttempt;
using testing::Stroke;

constexpr double exact = 1e-6;

scenarios::Scenario four_steps() {
  scenarios::Scenario scenario = testing::block_scenario();
  scenario.steps = {{StepKind::Verify, "", "", "", ""},
                    {StepKind::Cut, "", "", "eminence", ""},
                    {StepKind::Remove, "", "", "eminence", ""},
                    {StepKind::Finish, "", "", "", ""}};
  return scenario;
}

/// The cut is sawn from tick 10 on; what else was done, at its tick.
struct Done {
  std::int64_t verified = -1, removed = -1, finished = -1;
};

Finding order_of(const Done& done, const std::vector<Stroke>& strokes = {Stroke{}}) {
  ExaminedAttempt made = examined(four_steps(), strokes);
  const auto say = [&](std::int64_t tick, CutEventKind kind, std::int32_t subject) {
    if (tick >= 0) made.recording.events.push_back({tick, kind, subject, 0, {}});
  };
  say(done.verified, CutEventKind::StepDone, 0);
  say(done.removed, CutEventKind::PieceRemoved, 1);
  say(done.finished, CutEventKind::Finished, -1);
  std::stable_sort(made.recording.events.begin(), made.recording.events.end(),
                   [](const auto& a, const auto& b) { return a.tick < b.tick; });
  return measure_step_order(made.evidence());
}

/// Of the block's only stroke.
constexpr std::int64_t end_tick = 10 + 413;

TEST(StepOrder, InOrderIsOne) {
  const Finding order = order_of({.verified = 5, .removed = 500, .finished = 600});
  EXPECT_NEAR(order.value, 1.0, exact);
  EXPECT_EQ(order.first_tick, end_tick);
}

TEST(StepOrder, OfTwoSwappedStepsOneIsLeftOut) {
  const Finding late = order_of({.verified = 300, .removed = 500, .finished = 600});
  EXPECT_NEAR(late.value, 0.75, exact);
  EXPECT_TRUE(late.first_tick == 300 || late.first_tick == 10) << late.first_tick;
  EXPECT_NEAR(order_of({.verified = 5, .removed = 600, .finished = 500}).value, 0.75, exact);
}

TEST(StepOrder, OnlyOneOfFourThatWereDoneBackwardsIsKept) {
  EXPECT_NEAR(order_of({.verified = 300, .removed = 5, .finished = 2}).value, 0.25, exact);
}

TEST(StepOrder, TheMomentIsThatOfTheStepThatIsLeftOut) {
  // Verified, sawn and finished in order; the piece came out before all of it.
  const Finding early = order_of({.verified = 5, .removed = 2, .finished = 600});
  EXPECT_NEAR(early.value, 0.75, exact);
  EXPECT_EQ(early.first_tick, 2);
  EXPECT_EQ(early.last_tick, 2);
  // The other three are in order without the one that was verified last of all.
  EXPECT_EQ(order_of({.verified = 700, .removed = 500, .finished = 600}).first_tick, 700);
}

TEST(StepOrder, AStepLeftOutIsMissing) {
  const Finding order = order_of({.verified = 5, .finished = 600});
  EXPECT_NEAR(order.value, 0.75, exact);
  EXPECT_EQ(order.first_tick, end_tick);
  EXPECT_NEAR(order_of({}).value, 0.25, exact);
  EXPECT_NEAR(order_of({.verified = 5}, {}).value, 0.25, exact) << "nothing was sawn";
  EXPECT_EQ(order_of({}, {}).value, 0.0);
}

TEST(StepOrder, TheLastPieceThatCameOutCounts) {
  ExaminedAttempt made = examined(four_steps(), {Stroke{}});
  made.recording.events.push_back({500, CutEventKind::PieceRemoved, 1, 0, {}});
  made.recording.events.push_back({600, CutEventKind::Finished, -1, 0, {}});
  EXPECT_NEAR(measure_step_order(made.evidence()).value, 0.75, exact);
  made.recording.events.push_back({700, CutEventKind::PieceRemoved, 2, 0, {}});
  EXPECT_NEAR(measure_step_order(made.evidence()).value, 0.5, exact);
}

TEST(StepOrder, WithoutStepsNothingIsOutOfOrder) {
  ExaminedAttempt made = examined(testing::block_scenario(), std::vector<testing::Stroke>{});
  made.scenario.steps.clear();
  EXPECT_EQ(measure_step_order(made.evidence()).value, 1.0);
}

}  // namespace
}  // namespace hallux::assessment
