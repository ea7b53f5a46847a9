#include "ui/sight/view_judge.h"

#include <gtest/gtest.h>

#include <cstdio>

#include "simulator/base/units.h"
#include "tests/scenarios/hands/scripted_attempt.h"
#include "tests/ui/sight/recorded_moments.h"
#include "ui/render/gl/headless_context.h"
#include "ui/sight/start_place.h"

namespace hallux::ui {
namespace {

/// A shipped operation on a coarse patient.
class Judged : public testing::TestWithParam<const char*> {
 protected:
  scenarios::Scenario scenario_ = [] {
    scenarios::Scenario scenario = scenarios::load_shipped_scenario(GetParam());
    scenario.patient.edge_mm = 0.9;
    return scenario;
  }();
  simulator::Bone bone_ = make_patient_bones(scenario_).front();
  scenarios::Plan plan_ = plan_on(scenario_, bone_);
  HeadlessContext context_;
  ViewJudge judge_{scenario_, bone_, plan_};

  RigidTransform start_ = start_pose(scenario_, bone_, plan_);

  /// From where the scenario says, or another place.
  Camera camera() const { return start_camera(scenario_, bone_, plan_); }
  Camera camera_of(const scenarios::StartingPlace& place) const {
    scenarios::Scenario other = scenario_;
    other.start = place;
    return start_camera(other, bone_, plan_);
  }
};

TEST_P(Judged, TheStartViewHoldsAllThatIsAskedOfIt) {
  const ViewJudgement judgement = judge_.judge(camera(), start_);
  EXPECT_GE(degree_from_radian(judgement.blade_angle_rad), 25.0);
  EXPECT_LE(degree_from_radian(judgement.blade_angle_rad), 45.0);
  EXPECT_TRUE(judgement.is_saw_inside) << "in the picture, and under no panel";
  EXPECT_TRUE(judgement.is_from_lower_corner);
  EXPECT_GE(judgement.mean.tooth_line_share, 0.85);
  EXPECT_GE(judgement.mean.kerf_share, 0.85);
  EXPECT_TRUE(is_good(judgement));
}

TEST_P(Judged, AViewFromBehindTheBoneHidesTheCutAndIsToldSo) {
  scenarios::StartingPlace behind = *scenario_.start;
  behind.eye_in_bone = -behind.eye_in_bone;
  const ViewJudgement judgement = judge_.judge(camera_of(behind), start_);
  EXPECT_LT(judgement.mean.kerf_share, 0.3);
  EXPECT_GT(judgement.hiders.bone, judgement.hiders.blade + judgement.hiders.handpiece);
  EXPECT_FALSE(is_good(judgement));
}

TEST_P(Judged, AViewAlongTheBladeOrTooNearIsNoStart) {
  for (const BladeSight sight :
       {BladeSight::AcrossFromPlus, BladeSight::AcrossFromMinus, BladeSight::OverHandle}) {
    const Camera along = along_blade(camera(), start_, sight);
    const ViewJudgement edge_on = judge_.judge_start(along, start_);
    EXPECT_LT(degree_from_radian(edge_on.blade_angle_rad), 1.0);
    EXPECT_FALSE(holds_start(edge_on));
  }
  scenarios::StartingPlace near = *scenario_.start;
  near.radius_mm = 12.0;
  EXPECT_FALSE(judge_.judge_start(camera_of(near), start_).is_saw_inside);
}

TEST_P(Judged, TheStrokesOfThePlanOpenMoreAndMore) {
  ASSERT_GE(judge_.moments().size(), 8U);
  EXPECT_FALSE(judge_.moments().back().kerf.opened_mm.empty());
}

// One recording, some moments; more of them, on the bones as they ship, in sight_attempts_test.
TEST_P(Judged, FourFifthsAreSeenOverAnExpertsRecording) {
  const simulator::Recording recording = tests::run_hand(scenario_, bone_, "expert", 1).recording;
  const auto every_ticks = static_cast<std::int64_t>(recording.samples.size()) / 40;
  const std::vector<WorkMoment> moments =
      moments_of(recording, scenario_.saw.blade, bone_.world_from_bone, every_ticks);
  ASSERT_GT(moments.size(), 10U);
  const Visibility seen = judge_.seen_over(camera(), moments).mean;
  std::printf("%s: teeth %.3f, kerf %.3f over %zu moments\n", GetParam(), seen.tooth_line_share,
              seen.kerf_share, moments.size());
  EXPECT_GE(seen.tooth_line_share, 0.80);
  EXPECT_GE(seen.kerf_share, 0.80);
}

TEST_P(Judged, AViewAlongTheBladeLiesInItsPlaneAllOverTheStrokes) {
  for (const WorkMoment& moment : judge_.moments()) {
    for (const BladeSight sight :
         {BladeSight::AcrossFromPlus, BladeSight::AcrossFromMinus, BladeSight::OverHandle}) {
      const Camera along = along_blade(camera(), moment.world_from_tool, sight);
      const ViewJudgement seen = judge_.judge_start(along, moment.world_from_tool);
      EXPECT_LT(degree_from_radian(seen.blade_angle_rad), 1.0);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Shipped, Judged, testing::Values("silver", "akin"));

}  // namespace
}  // namespace hallux::ui
