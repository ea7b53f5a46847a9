#include "ui/sight/view_judge.h"

#include <gtest/gtest.h>

#include "tests/scenarios/hands/scripted_attempt.h"
#include "tests/ui/sight/recorded_moments.h"
#include "tests/ui/sight/start_views.h"
#include "ui/render/gl/headless_context.h"

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
  simulator::Bone bone_ = make_patient(scenario_);
  scenarios::Plan plan_ = plan_on(scenario_, bone_);
  HeadlessContext context_;
  ViewJudge judge_{scenario_, bone_, plan_};

  Camera camera_of(const StartView& view) const {
    return ui::camera_of(view, bone_.world_from_bone, judge_.site_in_bone_mm(), Viewer{}, 1.6);
  }
  ViewJudgement judge(const StartView& view) {
    return judge_.judge(camera_of(view), start_of(judge_));
  }
};

TEST_P(Judged, AGoodStartViewHoldsAllThatIsAskedOfIt) {
  const ViewJudgement judgement = judge(start_view_of(GetParam()));
  EXPECT_GE(degree_from_radian(judgement.blade_angle_rad), 25.0);
  EXPECT_LE(degree_from_radian(judgement.blade_angle_rad), 45.0);
  EXPECT_TRUE(judgement.is_saw_inside);
  EXPECT_TRUE(judgement.is_from_lower_corner);
  EXPECT_GE(judgement.mean.tooth_line_share, 0.85);
  EXPECT_GE(judgement.mean.kerf_share, 0.85);
  EXPECT_TRUE(is_good(judgement));
}

TEST_P(Judged, AViewFromBehindTheBoneHidesTheCutAndIsToldSo) {
  StartView view = start_view_of(GetParam());
  view.azimuth_rad += pi;
  view.elevation_rad = -view.elevation_rad;
  const ViewJudgement judgement = judge(view);
  EXPECT_LT(judgement.mean.kerf_share, 0.3);
  EXPECT_GT(judgement.hiders.bone, judgement.hiders.blade + judgement.hiders.handpiece);
  EXPECT_FALSE(is_good(judgement));
}

TEST_P(Judged, AViewAlongTheBladeOrTooNearIsNone) {
  Camera along = camera_of(start_view_of(GetParam()));
  along = along_blade(along, start_of(judge_), BladeSight::AcrossFromMinus);
  const ViewJudgement edge_on = judge_.judge_start(along, start_of(judge_));
  EXPECT_LT(degree_from_radian(edge_on.blade_angle_rad), 1.0);
  StartView near = start_view_of(GetParam());
  near.radius_mm = 12.0;
  EXPECT_FALSE(judge_.judge_start(camera_of(near), start_of(judge_)).is_saw_inside);
}

TEST_P(Judged, TheStrokesOfThePlanOpenMoreAndMore) {
  ASSERT_GE(judge_.moments().size(), 8U);
  EXPECT_FALSE(judge_.moments().back().kerf.opened_mm.empty());
}

class JudgedSilver : public Judged {};

// One recording, some moments; more of them, on the bones as they ship, in sight_attempts_test.
TEST_P(JudgedSilver, FourFifthsAreSeenOverAnExpertsRecording) {
  const simulator::Recording recording = tests::run_hand(scenario_, bone_, "expert", 1).recording;
  const std::vector<WorkMoment> moments =
      moments_of(recording, scenario_.saw.blade, bone_.world_from_bone, 1500);
  ASSERT_GT(moments.size(), 10U);
  const Visibility seen = judge_.seen_over(camera_of(start_view_of(GetParam())), moments);
  EXPECT_GE(seen.tooth_line_share, 0.80);
  EXPECT_GE(seen.kerf_share, 0.80);
}

INSTANTIATE_TEST_SUITE_P(Shipped, JudgedSilver, testing::Values("silver"));
INSTANTIATE_TEST_SUITE_P(Shipped, Judged, testing::Values("silver", "akin"));

TEST(StartViews, LookFromWhereTheirAnglesSay) {
  const auto from = [](const StartView& view) {
    return camera_of(view, {}, Vec3(1.0, 2.0, 3.0), Viewer{}, 1.6).world_from_view *
           Vec3(0.0, 0.0, 1.0);
  };
  EXPECT_GT(from({.azimuth_rad = 0.0}).x, 0.999) << "from distal";
  EXPECT_LT(from({.azimuth_rad = -0.5 * pi}).z, -0.999) << "from medial";
  EXPECT_GT(from({.elevation_rad = 0.5 * pi}).y, 0.999) << "from dorsal";
  const Camera rolled = camera_of({.roll_rad = 0.5 * pi}, {}, Vec3(0.0), Viewer{}, 1.6);
  const Vec3 right = rolled.world_from_view * Vec3(1.0, 0.0, 0.0);
  EXPECT_GT(right.y, 0.999) << "dorsal has turned clockwise to the right";
  const Camera fits = camera_of({.radius_mm = 20.0}, {}, Vec3(1.0, 2.0, 3.0), Viewer{}, 1.6);
  EXPECT_EQ(fits.target_mm, Vec3(1.0, 2.0, 3.0));
  EXPECT_NEAR(fits.magnification, 0.94 * Viewer{}.screen_width_mm / 1.6 / 40.0, 1.0e-9);
}

}  // namespace
}  // namespace hallux::ui
