#include "assessment/rebuild/joint_margin.h"

#include <gtest/gtest.h>

#include "tests/assessment/examined_attempt.h"

namespace hallux::assessment {
namespace {

using testing::examined;
using testing::ExaminedAttempt;
using testing::Stroke;

/// Poses are recorded to 1 um.
constexpr double pose_mm = 0.002;

/// A whole side of the block is a joint's.
scenarios::Scenario with_joint(const Vec3& facing) {
  scenarios::Scenario scenario = testing::block_scenario();
  scenarios::JointSurface joint;
  joint.name = "side";
  joint.title = "side of the block";
  joint.around = "axis_proximal";
  joint.radius_mm = 100.0;
  joint.facing_in_bone = facing;
  joint.within_rad = 0.1;
  scenario.joint_surfaces = {joint};
  return scenario;
}

void expect_margin(const ExaminedAttempt& made, double exact_mm) {
  const Measurement& margin = made.found("joint_margin_mm");
  ASSERT_TRUE(margin.is_measured());
  EXPECT_GE(margin.value, exact_mm - pose_mm);
  EXPECT_LE(margin.value, exact_mm + margin.bound + pose_mm);
}

TEST(JointMargin, OfASideBesideTheKerfIsItsWallsDistance) {
  // The kept wall lies in z = -8, the block's lateral side in z = 8.
  const ExaminedAttempt made = examined(with_joint({0.0, 0.0, 1.0}), {Stroke{}});
  EXPECT_NEAR(made.value("joint_margin_mm"), 16.0, pose_mm);
  const Detail& nearest = made.found("joint_margin_mm").detail;
  EXPECT_EQ(nearest.kind, DetailKind::NearestJoint);
  EXPECT_NE(nearest.words.at(0).find("side of the block"), std::string::npos);
  // The wall beyond the kerf is the nearer one to the medial side.
  EXPECT_NEAR(examined(with_joint({0.0, 0.0, -1.0}), {Stroke{}}).value("joint_margin_mm"), 3.5,
              pose_mm);
}

TEST(JointMargin, OfASideAheadOfTheTeethIsWithinItsBound) {
  for (const double last_y_mm : {-2.0, -2.03, -2.05, -2.07, -2.1, -7.0}) {
    const ExaminedAttempt made =
        examined(with_joint({0.0, -1.0, 0.0}), {Stroke{.last_y_mm = last_y_mm}});
    // The last tick stands within 0.05 mm of where the stroke was to end.
    const RigidTransform bone_from_tool =
        inverse(made.bone.world_from_bone) *
        transform_from(made.recording.samples.back().world_from_tool);
    expect_margin(made, bone_from_tool.translation_mm.y + 10.0);
  }
}

TEST(JointMargin, OfASideBesideTheToothLineIsWithinItsBound) {
  for (const double width_mm : {40.0, 40.1, 40.14, 40.19}) {
    scenarios::Scenario scenario = with_joint({1.0, 0.0, 0.0});
    scenario.saw.blade.width_mm = width_mm;
    // The blade stands over the middle of the block's 60 mm.
    expect_margin(examined(scenario, {Stroke{}}), 30.0 - 0.5 * width_mm);
  }
}

TEST(JointMargin, OfAJointThatIsCutIsNought) {
  // The kerf takes the block's medial edge, and with it the corners of its distal end.
  const ExaminedAttempt made = examined(with_joint({1.0, 0.0, 0.0}), {Stroke{.face_z_mm = -11.75}});
  EXPECT_EQ(made.value("joint_margin_mm"), 0.0);
  EXPECT_NEAR(made.found("joint_margin_mm").place_in_bone_mm.z, -12.0, 1e-9);
  // Through the middle of that end: its corners stand.
  const ExaminedAttempt middle = examined(with_joint({1.0, 0.0, 0.0}), {Stroke{.face_z_mm = 0.0}});
  expect_margin(middle, 0.0);
}

TEST(JointMargin, TheNearestOfAllKerfsCounts) {
  const ExaminedAttempt made = examined(with_joint({0.0, 0.0, 1.0}),
                                        {Stroke{}, Stroke{.face_z_mm = -5.0, .last_y_mm = 5.0}});
  EXPECT_NEAR(made.value("joint_margin_mm"), 13.0, pose_mm);
}

TEST(JointMargin, WithoutAJointOrAKerfThereIsNone) {
  EXPECT_EQ(examined(testing::block_scenario(), {Stroke{}}).found("joint_margin_mm").absence,
            Absence::Undefined);
  EXPECT_EQ(
      examined(with_joint({0.0, 0.0, 1.0}), std::vector<Stroke>{}).found("joint_margin_mm").absence,
      Absence::NotMade);
}

}  // namespace
}  // namespace hallux::assessment
