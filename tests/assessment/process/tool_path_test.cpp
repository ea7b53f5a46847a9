#include "assessment/process/tool_path.h"

#include <gtest/gtest.h>

#include "scenarios/hands/planned_strokes.h"
#include "tests/assessment/examined_attempt.h"
#include "tests/assessment/process/made_recording.h"

namespace hallux::assessment {
namespace {

using testing::examined;
using testing::ExaminedAttempt;

/// Of the low pass, which swings a little beyond a place at which a movement ends.
constexpr double swung = 1e-4;

/// Goes straight to a place in 2 s with the least jerk, and rests there.
void go_to(ExaminedAttempt& made, Vec3& place_mm, const Vec3& to_mm) {
  const Vec3 from_mm = place_mm;
  for (int tick = 1; tick <= 2000; ++tick) {
    const double time = tick / 2000.0;
    const double share = time * time * time * (10.0 - 15.0 * time + 6.0 * time * time);
    place_mm = from_mm + share * (to_mm - from_mm);
    testing::add_line(made.recording,
                      {.status = testing::running,
                       .tip_mm = transform_point(made.bone.world_from_bone, place_mm)});
  }
  testing::add_lines(
      made.recording,
      {.status = testing::running, .tip_mm = transform_point(made.bone.world_from_bone, place_mm)},
      200);
}

struct Way {
  ExaminedAttempt made = examined(testing::block_scenario(), std::vector<testing::Stroke>{});
  Vec3 start_mm{30.0, 40.0, -8.0}, begin_mm{0.0, 0.0, 0.0}, end_mm{0.0, 0.0, 0.0};

  Way() {
    const auto strokes =
        planned_strokes(made.scenario, made.bone, plan_on(made.scenario, made.bone));
    EXPECT_EQ(strokes.size(), 1U) << "the blade is wider than the block";
    begin_mm = strokes[0].bone_from_tool(strokes[0].first_mm).translation_mm;
    end_mm = strokes[0].bone_from_tool(strokes[0].last_mm).translation_mm;
  }
  double shortest_mm() const {
    return length_of(begin_mm - start_mm) + 2.0 * length_of(end_mm - begin_mm);
  }
  std::optional<Finding> ratio() const {
    return measure_path_ratio(made.evidence(), simulator::Bvh(made.bone.outer));
  }
};

TEST(ToolPath, StraightThereAndBackIsOne) {
  Way way;
  Vec3 place_mm = way.start_mm;
  for (const Vec3& to_mm : {way.start_mm, way.begin_mm, way.end_mm, way.begin_mm})
    go_to(way.made, place_mm, to_mm);
  const Finding ratio = way.ratio().value();
  EXPECT_NEAR(ratio.value, 1.0, swung);
  EXPECT_EQ(ratio.first_tick, 0);
  EXPECT_EQ(ratio.last_tick, 8799);
}

TEST(ToolPath, EachDetourCountsForItsWay) {
  Way way;
  Vec3 place_mm = way.start_mm;
  const Vec3 aside_mm = way.begin_mm + Vec3{0.0, 0.0, -12.0};
  for (const Vec3& to_mm : {way.start_mm, way.begin_mm, way.end_mm, way.begin_mm, way.end_mm,
                            way.begin_mm, aside_mm, way.begin_mm})
    go_to(way.made, place_mm, to_mm);
  const double more_mm = 2.0 * length_of(way.end_mm - way.begin_mm) + 24.0;
  EXPECT_NEAR(way.ratio()->value, 1.0 + more_mm / way.shortest_mm(), swung);
}

TEST(ToolPath, WhatIsFarFromTheBoneIsNoWayOfIt) {
  Way way;
  Vec3 place_mm{30.0, 200.0, -8.0};
  go_to(way.made, place_mm, Vec3{30.0, 300.0, -8.0});
  EXPECT_FALSE(way.ratio()) << "it never came near";
  // In through 50 mm above the block's dorsal side: there the way begins.
  for (const Vec3& to_mm : {way.begin_mm, way.end_mm, way.begin_mm})
    go_to(way.made, place_mm, to_mm);
  EXPECT_NEAR(way.ratio()->value, 1.0, 0.01);
  EXPECT_GT(way.ratio()->first_tick, 2200);
}

scenarios::PlannedImplant into_the_block(scenarios::ImplantKind kind, const std::string& name) {
  scenarios::PlannedImplant implant;
  implant.kind = kind;
  implant.name = name;
  implant.entry_in_bone_mm = {20.0, 10.0, 4.0};
  implant.length_mm = 12.0;
  return implant;
}

scenarios::OperationStep fixing(const std::string& implant) {
  scenarios::OperationStep step;
  step.kind = scenarios::StepKind::Fix;
  step.one_of = "fixing";
  step.implants = {implant};
  return step;
}

/// The cut, then what is fixed by a screw or by a wire in the same place.
class ToolPathOfImplants : public ::testing::Test {
 protected:
  ToolPathOfImplants() {
    way_.made.examination.plan.fixation.implants = {
        into_the_block(scenarios::ImplantKind::Screw, "screw"),
        into_the_block(scenarios::ImplantKind::Wire, "wire")};
    auto& steps = way_.made.scenario.steps;
    first_ = steps.size() - 1;
    steps.insert(steps.end() - 1, {fixing("screw"), fixing("wire")});
  }
  void do_step(std::size_t step) {
    way_.made.recording.events.push_back(
        {1, simulator::CutEventKind::StepDone, static_cast<std::int32_t>(step), 0, {}});
  }
  /// Sawn, and so often into the place and back.
  double ratio_with(int passes) {
    Vec3 place_mm = way_.start_mm;
    std::vector<Vec3> places{way_.start_mm, way_.begin_mm, way_.end_mm, way_.begin_mm};
    const Vec3 entry_mm{20.0, 10.0, 4.0}, tip_mm{20.0, -2.0, 4.0};
    for (int pass = 0; pass < passes; ++pass)
      places.insert(places.end(), {entry_mm, tip_mm, entry_mm});
    for (const Vec3& to_mm : places) go_to(way_.made, place_mm, to_mm);
    return way_.ratio()->value;
  }

  Way way_;
  std::size_t first_ = 0;
};

TEST_F(ToolPathOfImplants, AWireIsDriven) {
  do_step(first_ + 1);
  EXPECT_NEAR(ratio_with(1), 1.0, swung) << "of alternatives that which was done";
}

TEST_F(ToolPathOfImplants, AScrewIsDrilledForAndSet) {
  do_step(first_);
  EXPECT_NEAR(ratio_with(2), 1.0, swung);
}

TEST_F(ToolPathOfImplants, WhatWasLeftOutIsNotInThePlansWay) {
  EXPECT_NEAR(ratio_with(0), 1.0, swung);
}

TEST(ToolPath, OfAPlanWithoutStrokesThereIsNone) {
  Way way;
  way.made.scenario.steps.clear();
  Vec3 place_mm = way.start_mm;
  go_to(way.made, place_mm, way.start_mm);
  EXPECT_FALSE(way.ratio());
}

}  // namespace
}  // namespace hallux::assessment
