/// The wedge between an Akin's two faces: its base, the line in which they meet, and closing it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "assessment/measure_closing.h"
#include "simulator/base/units.h"
#include "tests/assessment/examined_attempt.h"

namespace hallux::assessment {
namespace {

using testing::AkinAttempt;
using testing::examined;
using testing::ExaminedAttempt;

/// Poses are recorded to 1 um and quaternions to 1e-6, which over 14 mm of face is 0.03 mm at
/// worst.
constexpr double pose_mm = 0.002;
constexpr double pose_deg = 5e-4;

double slope_of(double degree) { return std::tan(radian_from_degree(degree)); }

TEST(Base, IsTheGapAtTheEntryAlongTheBone) {
  EXPECT_NEAR(examined(testing::akin_scenario(), AkinAttempt{}).value("base_mm", "lateral"),
              14.0 * slope_of(10.0), pose_mm);
  EXPECT_NEAR(
      examined(testing::akin_scenario(), AkinAttempt{.transverse_deg = 3.0, .wedge_deg = 12.0})
          .value("base_mm", "lateral"),
      14.0 * (slope_of(15.0) - slope_of(3.0)), pose_mm);
}

// The planned hinge is the line x = 6, z = 6.5 along dorsal.
TEST(Apex, LiesWhereTheFacesMeet) {
  const ExaminedAttempt on_plan = examined(testing::akin_scenario(), AkinAttempt{});
  EXPECT_NEAR(on_plan.value("apex_offset_mm", "lateral"), 0.0, 0.01);
  EXPECT_NEAR(on_plan.value("apex_angle_deg", "lateral"), 0.0, 0.01);
  // In the first face, a millimetre short of the plan.
  EXPECT_NEAR(examined(testing::akin_scenario(), AkinAttempt{.apex_mm = 5.5})
                  .value("apex_offset_mm", "lateral"),
              1.0, 0.01);
  // 0.8 mm distal, 0.6 mm short.
  EXPECT_NEAR(examined(testing::akin_scenario(), AkinAttempt{.entry_x_mm = 6.8, .apex_mm = 5.9})
                  .value("apex_offset_mm", "lateral"),
              1.0, 0.01);
}

TEST(Apex, IsTurnedWhereBothFacesLeanAlike) {
  // Both contain (tangent of 4 degrees, -1, 0).
  const ExaminedAttempt made =
      examined(testing::akin_scenario(), AkinAttempt{.sagittal1_deg = 4.0, .sagittal2_deg = 4.0});
  EXPECT_NEAR(made.value("apex_angle_deg", "lateral"), 4.0, 0.01);
  EXPECT_NEAR(made.value("apex_offset_mm", "lateral"), 0.0, 0.01);
}

TEST(Apex, OfOneFaceAloneThereIsNone) {
  const ExaminedAttempt made = examined(testing::akin_scenario(), AkinAttempt{.has_second = false});
  for (const char* metric : {"base_mm", "apex_offset_mm", "apex_angle_deg"})
    EXPECT_EQ(made.found(metric, "lateral").absence, Absence::NotMade) << metric;
}

/// The distal half turned by so much about the planned hinge.
RigidTransform turned(double degree) {
  const Quat turn = rotation_about(Vec3{0.0, 1.0, 0.0}, radian_from_degree(degree));
  const RigidTransform about{turn, {0.0, 0.0, 0.0}};
  const Vec3 hinge_mm{6.0, 0.0, 6.5};
  return {turn, hinge_mm - transform_point(about, hinge_mm)};
}

ExaminedAttempt closed_by(double degree) {
  const simulator::Bone bone = testing::oval_bone();
  simulator::Recording recording = testing::akin_recording({}, bone);
  recording.events.push_back({recording.samples.back().tick + 1,
                              simulator::CutEventKind::HingeClosed, -1, 0,
                              simulator::quantise(turned(degree))});
  return examined(testing::akin_with_deeds(), bone, recording);
}

// A positive turn about dorsal takes x to -z: the toe goes medially, and the base closes.
TEST(Closing, BringsTheFacesTogether) {
  const ExaminedAttempt made = closed_by(10.0);
  EXPECT_NEAR(made.value("correction_deg", "lateral"), 10.0, pose_deg);
  EXPECT_NEAR(made.value("gap_mm", "lateral"), 0.0, pose_mm);
  EXPECT_EQ(made.value("contact_share", "lateral"), 1.0);
}

TEST(Closing, ShortensTheBoneByWhereItsEndCame) {
  for (const double degree : {4.0, 10.0}) {
    const double angle_rad = radian_from_degree(degree);
    // From the hinge the end lies 21 mm distal and 6.5 mm medial.
    const double x_mm = 6.0 + 21.0 * std::cos(angle_rad) - 6.5 * std::sin(angle_rad);
    const double z_mm = 6.5 - 21.0 * std::sin(angle_rad) - 6.5 * std::cos(angle_rad);
    EXPECT_NEAR(closed_by(degree).value("shortening_mm", "lateral"), 27.0 - std::hypot(x_mm, z_mm),
                pose_mm);
  }
}

TEST(Closing, ThatStopsShortLeavesAGapAtTheBase) {
  const ExaminedAttempt made = closed_by(6.0);
  EXPECT_NEAR(made.value("correction_deg", "lateral"), 6.0, pose_deg);
  const double slope = std::sin(radian_from_degree(4.0));
  double widest_mm = 0.0, touching = 0.0;
  const CutFace& first = made.examination.faces[0][0];
  for (const Vec3& sample_mm : first.samples_in_bone_mm) {
    const double apart_mm = (6.5 - sample_mm.z) * slope;
    widest_mm = std::max(widest_mm, apart_mm);
    touching += apart_mm <= 0.2 ? 1.0 : 0.0;
  }
  EXPECT_NEAR(made.value("gap_mm", "lateral"), widest_mm, pose_mm);
  EXPECT_NEAR(widest_mm, 14.0 * slope, 0.25 * slope);
  // A row of samples may lie within the poses' rounding of the limit.
  EXPECT_NEAR(made.value("contact_share", "lateral"),
              touching / static_cast<double>(first.samples_in_bone_mm.size()), 0.02);
  EXPECT_NEAR(made.found("gap_mm", "lateral").place_in_bone_mm.z, -7.5, 0.3);
}

TEST(Closing, TurnedTheOtherWayIsNegative) {
  EXPECT_NEAR(closed_by(-3.0).value("correction_deg", "lateral"), -3.0, pose_deg);
}

TEST(Closing, ThatWasNotDoneHasNoNumbers) {
  const ExaminedAttempt made = examined(testing::akin_with_deeds(), AkinAttempt{});
  for (const char* metric : {"correction_deg", "shortening_mm", "gap_mm", "contact_share"})
    EXPECT_EQ(made.found(metric, "lateral").absence, Absence::NotDone) << metric;
}

}  // namespace
}  // namespace hallux::assessment
