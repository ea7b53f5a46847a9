// The hand without errors: it aims at the plan itself, stops at the planned line, and does the
// whole operation.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "scenarios/hands/planned_strokes.h"
#include "tests/scenarios/format_1/format_1.h"
#include "tests/scenarios/hands/scripted_attempt.h"

namespace hallux::scenarios {
namespace {

using simulator::CommandKind;
using simulator::CutEventKind;
using simulator::Recording;

/// An operation of format 1 on a coarse patient, and what the hand aims at there.
struct Operation {
  explicit Operation(const char* name) : scenario(scenarios_test::format_1(name)) {
    scenario.patient.edge_mm = 0.9;
    bone = make_patient_bones(scenario).front();
    plan = plan_on(scenario, bone);
  }
  std::vector<AimedCut> aimed(std::uint64_t seed) const {
    return aim(scenario, plan, KnownBones(bone), hand_skill("perfect"), seed);
  }
  Recording operated(std::uint64_t seed) const {
    return tests::run_hand(scenario, bone, "perfect", seed).recording;
  }

  Scenario scenario;
  simulator::Bone bone;
  Plan plan;
};

std::ptrdiff_t events_of(const Recording& recording, CutEventKind kind) {
  return std::count_if(recording.events.begin(), recording.events.end(),
                       [kind](const simulator::CutEvent& event) { return event.kind == kind; });
}

TEST(PerfectHand, AimsAtThePlanItself) {
  for (const char* name : {"silver", "akin"}) {
    const Operation operation(name);
    for (const std::uint64_t seed : {1U, 2U, 77U}) {
      const std::vector<AimedCut> cuts = operation.aimed(seed);
      ASSERT_EQ(cuts.size(), operation.plan.cuts.size());
      for (std::size_t i = 0; i < cuts.size(); ++i) {
        const ReferenceFace& planned = operation.plan.cuts[i].face;
        EXPECT_LT(std::sqrt(squared_length(cuts[i].face.normal - planned.normal)), 1.0e-9) << name;
        EXPECT_NEAR(cuts[i].face.offset_mm, planned.offset_mm, 1.0e-9) << name << ' ' << i;
        EXPECT_EQ(cuts[i].angle_error_rad, 0.0);
        EXPECT_NEAR(cuts[i].location_error_mm, 0.0, 1.0e-9);
        // The blade lies half a kerf off the finished face, in the waste.
        const Vec3& origin = cuts[i].plane.bone_from_kerf.translation_mm;
        EXPECT_NEAR(glm::dot(planned.normal, origin) - planned.offset_mm,
                    0.5 * operation.scenario.saw.blade.kerf_mm, 1.0e-9);
      }
    }
  }
}

TEST(PerfectHand, StopsAtThePlannedLine) {
  const Operation akin("akin");
  const simulator::HingeLine& line = akin.plan.hinges.at(0).bridge.line;
  for (const AimedCut& cut : akin.aimed(1)) {
    const Vec3 stop =
        transform_point(cut.plane.bone_from_kerf, Vec3{cut.stop_mm.value(), 0.0, 0.0});
    const Vec3 feed = axis_x(cut.plane.bone_from_kerf);
    EXPECT_NEAR(glm::dot(feed, stop - line.point_in_bone_mm), 0.0, 1.0e-9);
    EXPECT_FALSE(cut.loses_hinge);
  }
}

TEST(PerfectHand, SawsTheStrokesOfThePlan) {
  for (const char* name : {"silver", "akin"}) {
    const Operation operation(name);
    const std::vector<AimedCut> cuts = operation.aimed(1);
    const std::vector<PlannedStroke> strokes =
        planned_strokes(operation.scenario, operation.bone, operation.plan);
    ASSERT_FALSE(strokes.empty());
    for (const PlannedStroke& stroke : strokes) {
      EXPECT_EQ(stroke.plane.bone_from_kerf, cuts.at(stroke.cut).plane.bone_from_kerf);
      EXPECT_LE(stroke.last_mm, cuts[stroke.cut].stop_mm.value_or(1000.0));
    }
  }
}

/// All that a hand does whoever looks: the saw and the water run before the teeth meet bone, no
/// zone is touched, no bone is hot, each step is declared in order, the end comes by itself.
void expect_faultless(const Operation& operation, const Recording& recording) {
  std::int32_t next_step = 0;
  for (const simulator::TapeLine& line : recording.tape) {
    for (std::size_t i = 0; i < line.command_count; ++i) {
      if (line.commands[i].kind != CommandKind::StepDone) continue;
      EXPECT_EQ(line.commands[i].argument, next_step++);
    }
  }
  EXPECT_EQ(next_step, static_cast<std::int32_t>(operation.scenario.steps.size()));
  for (const simulator::ToolSample& sample : recording.samples) {
    if (!has(sample.status, simulator::ToolStatus::InContact)) continue;
    ASSERT_TRUE(has(sample.status, simulator::ToolStatus::SawOn)) << sample.tick;
    ASSERT_TRUE(has(sample.status, simulator::ToolStatus::Irrigated)) << sample.tick;
  }
  EXPECT_EQ(events_of(recording, CutEventKind::DangerContact), 0);
  EXPECT_EQ(events_of(recording, CutEventKind::BoneHot), 0);
  const auto cuts = static_cast<std::ptrdiff_t>(operation.plan.cuts.size());
  EXPECT_EQ(events_of(recording, CutEventKind::PlaneFrozen), cuts) << "no false start";
  EXPECT_GE(events_of(recording, CutEventKind::PieceFreed), 1);
  EXPECT_EQ(events_of(recording, CutEventKind::PieceRemoved),
            events_of(recording, CutEventKind::PieceFreed));
  EXPECT_EQ(recording.events.back().kind, CutEventKind::Finished);
  EXPECT_LT(recording.tape.back().tick, FeelingHand::last_tick - 1000);
}

TEST(PerfectHand, TakesTheEminenceOff) {
  const Operation silver("silver");
  const Recording recording = silver.operated(1);
  expect_faultless(silver, recording);
  EXPECT_EQ(events_of(recording, CutEventKind::SectionCovered), 1);
  EXPECT_EQ(recording.tape, silver.operated(1).tape);
  // Nothing is left to chance.
  EXPECT_EQ(recording.tape, silver.operated(2).tape);
}

TEST(PerfectHand, TakesTheWedgeOutAndClosesIt) {
  const Operation akin("akin");
  const Recording recording = akin.operated(1);
  expect_faultless(akin, recording);
  EXPECT_EQ(events_of(recording, CutEventKind::HingeClosed), 1);
}

}  // namespace
}  // namespace hallux::scenarios
