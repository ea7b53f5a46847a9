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

/// Steps of format 2: the cut and a mark come after the verify in any order, the removal after
/// the cut.
scenarios::Scenario ordered_steps() {
  scenarios::Scenario scenario = testing::block_scenario();
  scenario.format = 2;
  const auto step = [&](StepKind kind, const std::string& id, std::vector<std::string> after) {
    scenarios::OperationStep made;
    made.kind = kind;
    made.id = id;
    made.after = std::move(after);
    if (kind == StepKind::Cut || kind == StepKind::Remove) made.cut = "eminence";
    return made;
  };
  scenario.steps = {step(StepKind::Verify, "verify", {}), step(StepKind::Mark, "mark", {"verify"}),
                    step(StepKind::Cut, "cut", {"verify"}),
                    step(StepKind::Remove, "remove", {"cut"}),
                    step(StepKind::Finish, "finish", {"remove", "mark"})};
  return scenario;
}

struct Said {
  std::int64_t tick = 0;
  CutEventKind kind = CutEventKind::StepDone;
  std::int32_t subject = 0;
};

double ordered_share(const scenarios::Scenario& scenario, const std::vector<Said>& all) {
  ExaminedAttempt made = examined(scenario, {Stroke{}});
  for (const Said& said : all)
    made.recording.events.push_back({said.tick, said.kind, said.subject, 0, {}});
  std::stable_sort(made.recording.events.begin(), made.recording.events.end(),
                   [](const auto& a, const auto& b) { return a.tick < b.tick; });
  return measure_step_order(made.evidence()).value;
}

/// Verified at 5, taken out at 500, done at 510, finished at 600; the cut begins at 10.
std::vector<Said> all_but_the_mark() {
  return {{5},
          {500, CutEventKind::PieceRemoved, 1},
          {510, CutEventKind::StepDone, 3},
          {600, CutEventKind::Finished, -1}};
}

TEST(StepOrder, WhatComesAfterTheSameStepHasNoOrder) {
  for (const std::int64_t marked : {8, 300, 550}) {
    std::vector<Said> all = all_but_the_mark();
    all.push_back({marked, CutEventKind::StepDone, 1});
    EXPECT_NEAR(ordered_share(ordered_steps(), all), 1.0, exact) << marked;
  }
}

TEST(StepOrder, AStepBeforeWhatItComesAfterIsOutOfOrder) {
  std::vector<Said> all = all_but_the_mark();
  all.push_back({2, CutEventKind::StepDone, 1});
  EXPECT_NEAR(ordered_share(ordered_steps(), all), 0.8, exact);
}

TEST(StepOrder, WhatMayBePassedOverIsMissedByNobody) {
  EXPECT_NEAR(ordered_share(ordered_steps(), all_but_the_mark()), 0.8, exact);
  scenarios::Scenario scenario = ordered_steps();
  scenario.steps[1].is_optional = true;
  EXPECT_NEAR(ordered_share(scenario, all_but_the_mark()), 1.0, exact);
}

/// The mark or another one.
scenarios::Scenario steps_with_alternatives() {
  scenarios::Scenario scenario = ordered_steps();
  scenario.steps[1].one_of = "marking";
  scenarios::OperationStep other = scenario.steps[1];
  other.id = "guide";
  scenario.steps.insert(scenario.steps.begin() + 2, other);
  return scenario;
}

TEST(StepOrder, OfAlternativesOneSuffices) {
  std::vector<Said> all = all_but_the_mark();
  all[2].subject = 4;
  all.push_back({300, CutEventKind::StepDone, 2});
  EXPECT_NEAR(ordered_share(steps_with_alternatives(), all), 1.0, exact);
}

TEST(StepOrder, OfAlternativesThatNobodyCarriedOutOneIsMissing) {
  std::vector<Said> all = all_but_the_mark();
  all[2].subject = 4;
  EXPECT_NEAR(ordered_share(steps_with_alternatives(), all), 0.8, exact);
}

TEST(StepOrder, PiecesThatAreTakenOutAfterAStepWasDoneAreNotItsOwn) {
  std::vector<Said> all = all_but_the_mark();
  all.push_back({300, CutEventKind::StepDone, 1});
  all.push_back({590, CutEventKind::PieceRemoved, 2});
  EXPECT_NEAR(ordered_share(ordered_steps(), all), 1.0, exact);
}

}  // namespace
}  // namespace hallux::assessment
