#include "assessment/rebuild/cut_of_kerf.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "scenarios/site/kerf_of_cut.h"
#include "tests/assessment/akin_attempt.h"

namespace hallux::assessment {
namespace {

using scenarios::OperationStep;
using scenarios::StepKind;
using simulator::CutEvent;
using simulator::CutEventKind;
using simulator::Recording;
using testing::AkinAttempt;
using Cuts = std::vector<std::size_t>;

constexpr double kerf_mm = 0.5;
constexpr std::int32_t first_step = 1, second_step = 2;

/// Sawn the wrong way round: the first kerf lies in the second cut's plane.
constexpr AkinAttempt turned_round{.is_second_first = true};
/// A wedge of eight degrees that leans far distal, its distal face in the sagittal plane, too:
/// that one loses least by going to the first cut.
constexpr AkinAttempt leaning{
    .entry_x_mm = 8.4, .transverse_deg = 18.0, .wedge_deg = 8.0, .sagittal2_deg = 10.0};

std::vector<OperationStep> steps() {
  std::vector<OperationStep> made(4);
  made[first_step].kind = made[second_step].kind = StepKind::Cut;
  made[first_step].cut = "cut1";
  made[second_step].cut = "cut2";
  made[3].kind = StepKind::Finish;
  return made;
}

struct Said {
  std::int64_t tick = 0;
  std::int32_t step = 0;
  CutEventKind kind = CutEventKind::StepDone;
};

void say(Recording& recording, const std::vector<Said>& said) {
  for (const Said& each : said) {
    CutEvent event;
    event.tick = each.tick;
    event.subject = each.step;
    event.kind = each.kind;
    recording.events.push_back(event);
  }
  std::ranges::stable_sort(recording.events, {}, &CutEvent::tick);
}

Recording recording_of(const AkinAttempt& attempt) {
  return akin_recording(attempt, testing::oval_bone(), kerf_mm);
}

/// The kerfs of `later`, sawn after those of `recording`.
void append(Recording& recording, const Recording& later) {
  const std::int64_t ticks = recording.samples.back().tick + 100;
  const auto kerfs = static_cast<std::int32_t>(recording.events.size());
  for (CutEvent event : later.events) {
    event.tick += ticks;
    event.subject += kerfs;
    recording.events.push_back(event);
  }
  for (simulator::ToolSample sample : later.samples) {
    sample.tick += ticks;
    sample.kerf += kerfs;
    recording.samples.push_back(sample);
  }
}

std::int64_t first_tick_of(const Recording& recording, std::int32_t kerf) {
  return std::ranges::find(recording.samples, kerf, &simulator::ToolSample::kerf)->tick;
}

std::int64_t last_tick_of(const Recording& recording) { return recording.samples.back().tick; }

struct Shared {
  scenarios::Plan plan;
  RebuiltBone rebuilt;
  Cuts cuts;
};

Shared shared_of(const Recording& recording) {
  const simulator::Bone bone = testing::oval_bone();
  const scenarios::Scenario scenario = testing::akin_scenario(kerf_mm);
  scenarios::Plan plan = plan_on(scenario, bone);
  RebuiltBone rebuilt = rebuild(bone, scenario.saw.blade, recording);
  const std::vector<OperationStep> operation = steps();
  Cuts cuts = cuts_of_kerfs(rebuilt, plan, {operation, recording});
  return {std::move(plan), std::move(rebuilt), std::move(cuts)};
}

Cuts cuts_of(Recording recording, const std::vector<Said>& said) {
  say(recording, said);
  return shared_of(recording).cuts;
}

TEST(CutOfKerf, TheStepAtHandDecidesFirst) {
  const Recording recording = recording_of(turned_round);
  const std::int64_t second_tick = first_tick_of(recording, 1);
  EXPECT_EQ(cuts_of(recording, {}), (Cuts{1, 0})) << "nearness, where nobody said anything";
  EXPECT_EQ(cuts_of(recording, {{second_tick - 1, first_step}}), (Cuts{0, 1}))
      << "the second step is the one left over";
  EXPECT_EQ(
      cuts_of(recording, {{second_tick - 1, first_step}, {last_tick_of(recording), second_step}}),
      (Cuts{0, 1}));
  EXPECT_EQ(
      cuts_of(recording, {{second_tick - 1, second_step}, {last_tick_of(recording), first_step}}),
      (Cuts{1, 0}))
      << "steps may be done in any order";
}

TEST(CutOfKerf, DoneOfAStepThatIsNoCutSaysNothing) {
  const Recording recording = recording_of(turned_round);
  EXPECT_EQ(cuts_of(recording, {{first_tick_of(recording, 1) - 1, 0}}), (Cuts{1, 0}));
}

TEST(CutOfKerf, OfTwoKerfsInOneStepTheProximalOneIsTheProximalCut) {
  for (const std::int32_t at_hand : {first_step, second_step}) {
    for (const bool is_second_first : {false, true}) {
      AkinAttempt attempt = leaning;
      attempt.is_second_first = is_second_first;
      const Recording recording = recording_of(attempt);
      const std::int64_t end = last_tick_of(recording);
      const std::int64_t first_done = at_hand == first_step ? end + 1 : 5;
      EXPECT_EQ(cuts_of(recording, {{first_done, first_step}, {end + 2, second_step}}),
                is_second_first ? (Cuts{1, 0}) : (Cuts{0, 1}));
    }
  }
}

TEST(CutOfKerf, WhereTheStepsSayNothingTheOrderAtTheEntryDecides) {
  const Shared shared = shared_of(recording_of(leaning));
  const auto loss = [&](std::int32_t kerf) {
    const simulator::KerfPlane& plane = shared.rebuilt.fields.plane(kerf);
    return misfit(plane, shared.plan.cuts[0]) - misfit(plane, shared.plan.cuts[1]);
  };
  EXPECT_EQ(nearest_cut(shared.rebuilt.fields.plane(0), shared.plan), 1U);
  EXPECT_EQ(nearest_cut(shared.rebuilt.fields.plane(1), shared.plan), 1U);
  EXPECT_LT(loss(1), loss(0)) << "nearness would turn the wedge over";
  EXPECT_EQ(shared.cuts, (Cuts{0, 1}));
}

TEST(CutOfKerf, TheDistalOneOfThreeInOneStepIsTheDistalCut) {
  Recording recording = recording_of({.entry_x_mm = 5.0, .has_second = false});
  append(recording, recording_of({}));
  EXPECT_EQ(cuts_of(recording, {{last_tick_of(recording) + 1, first_step}}), (Cuts{0, 0, 1}));
}

TEST(CutOfKerf, KerfsThatCrossAtTheEntryGoWhereTheyLoseLeast) {
  // The faces lie 0.46 mm apart there, the middles of their kerfs 0.5 mm nearer: the wrong way
  // round by less than says anything.
  const AkinAttempt crossed{
      .transverse_deg = -6.0, .apex_mm = -4.9, .reach1_mm = 5.0, .reach2_mm = 5.0};
  for (const bool is_second_first : {false, true}) {
    AkinAttempt attempt = crossed;
    attempt.is_second_first = is_second_first;
    EXPECT_EQ(cuts_of(recording_of(attempt), {}), is_second_first ? (Cuts{1, 0}) : (Cuts{0, 1}));
  }
}

TEST(CutOfKerf, OneKerfThatNoStepSpeaksOfIsOfTheNearestPlane) {
  const Recording at_second =
      recording_of({.entry_x_mm = 8.4, .transverse_deg = 10.0, .has_second = false});
  EXPECT_EQ(cuts_of(at_second, {}), (Cuts{1}));
  EXPECT_EQ(cuts_of(at_second, {{5, first_step}, {6, second_step}}), (Cuts{1}))
      << "all cuts were done by then";
  EXPECT_EQ(cuts_of(at_second, {{last_tick_of(at_second) + 1, first_step}}), (Cuts{0}));
}

TEST(CutOfKerf, AStepThatWasTakenUpAgainIsAtHandUntilItIsDoneAnew) {
  constexpr CutEventKind again = CutEventKind::StepReopened;
  const Recording recording = recording_of(turned_round);
  const std::int64_t second_tick = first_tick_of(recording, 1), end = last_tick_of(recording);
  EXPECT_EQ(cuts_of(recording, {{5, first_step},
                                {8, first_step, again},
                                {second_tick - 1, first_step},
                                {end + 1, second_step}}),
            (Cuts{0, 1}));
  const Recording one =
      recording_of({.entry_x_mm = 8.4, .transverse_deg = 10.0, .has_second = false});
  EXPECT_EQ(cuts_of(one, {{5, first_step}, {6, second_step}, {8, first_step, again}}), (Cuts{0}))
      << "it was not done anew";
  EXPECT_EQ(cuts_of(recording, {{second_tick - 1, first_step},
                                {end + 1, first_step, again},
                                {end + 2, first_step},
                                {end + 3, second_step}}),
            (Cuts{0, 1}))
      << "what was sawn before it was taken up again is not of it";
}

TEST(CutOfKerf, AFalseStartInAnotherStepChangesNothing) {
  const Recording recording = recording_of(turned_round);
  const std::int64_t second_tick = first_tick_of(recording, 1);
  EXPECT_EQ(cuts_of(recording, {{second_tick + 12, first_step}}), (Cuts{0, 1}))
      << "a dozen samples of the second kerf lie in the first step";
  EXPECT_EQ(cuts_of(recording, {{second_tick + 100, first_step}}), (Cuts{1, 0}))
      << "a third of it does: two kerfs of one step";

  Recording with_scratch = recording_of({});
  append(with_scratch, recording_of({.entry_x_mm = 9.5, .reach1_mm = -6.8, .has_second = false}));
  EXPECT_EQ(cuts_of(with_scratch, {{first_tick_of(with_scratch, 2) - 1, first_step}}),
            (Cuts{0, 1, 1}))
      << "a scratch in the second step is not the second cut";
}

}  // namespace
}  // namespace hallux::assessment
