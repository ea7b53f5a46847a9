#include "scenarios/plan.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "simulator/base/units.h"
#include "tests/scenarios/format_1/format_1.h"

namespace hallux::scenarios {
namespace {

using simulator::Bone;

/// Each value below is a handful of roundings of numbers under 100.
constexpr double rounding = 1.0e-13;

/// A block 60 x 20 x 20 mm about the x axis, with the landmarks that Silver asks for.
Bone block_bone() {
  Bone bone;
  bone.name = "block";
  for (int i = 0; i < 8; ++i) {
    bone.outer.points_mm.emplace_back((i & 1) != 0 ? 60.0 : 0.0, (i & 2) != 0 ? 10.0 : -10.0,
                                      (i & 4) != 0 ? 10.0 : -10.0);
  }
  bone.outer.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                          {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  bone.landmarks = {{"shaft_proximal", Vec3(20.0, 0.0, 0.0)},
                    {"shaft_distal", Vec3(40.0, 0.0, 0.0)},
                    {"med_sulcus", Vec3(52.0, 4.0, -6.0)},
                    {"shaft_medial", Vec3(30.0, 0.0, -10.0)}};
  return bone;
}

Scenario silver_with_tilt(double tilt_deg) {
  Scenario scenario = scenarios_test::format_1("silver");
  scenario.cuts[0].face.frontal_tilt_rad = radian_from_degree(tilt_deg);
  scenario.joint_surfaces.clear();
  return scenario;
}

void expect_near(const Vec3& a, const Vec3& b) {
  EXPECT_NEAR(a.x, b.x, rounding);
  EXPECT_NEAR(a.y, b.y, rounding);
  EXPECT_NEAR(a.z, b.z, rounding);
}

/// z of the face at (x, y).
double face_z_mm(const ReferenceFace& face, double x_mm, double y_mm) {
  return (face.offset_mm - face.normal.x * x_mm - face.normal.y * y_mm) / face.normal.z;
}

std::string refusal_of(const Scenario& scenario, const Bone& bone) {
  try {
    plan_on(scenario, bone);
  } catch (const ScenarioError& error) {
    return error.what();
  }
  return "";
}

TEST(Plan, WithoutTiltLiesOneMillimetreMedialToTheSulcus) {
  const PlannedCut cut = plan_on(silver_with_tilt(0.0), block_bone()).cuts.at(0);
  EXPECT_EQ(cut.name, "eminence");
  expect_near(cut.face.normal, Vec3(0.0, 0.0, -1.0));
  EXPECT_NEAR(cut.face.offset_mm, 7.0, rounding);
  expect_near(cut.axis, Vec3(1.0, 0.0, 0.0));
  expect_near(cut.depth_point_in_bone_mm, Vec3(52.0, 4.0, -6.0));
  expect_near(cut.exit_point_in_bone_mm, Vec3(30.0, 0.0, -10.0));
  EXPECT_NEAR(cut.depth_mm, 1.0, rounding);
}

TEST(Plan, TiltedRunsFurtherMedialTowardsPlantar) {
  const PlannedCut cut = plan_on(silver_with_tilt(5.0), block_bone()).cuts.at(0);
  const double sine = std::sin(radian_from_degree(5.0));
  const double cosine = std::cos(radian_from_degree(5.0));
  expect_near(cut.face.normal, Vec3(0.0, sine, -cosine));
  EXPECT_NEAR(cut.face.offset_mm, 4.0 * sine + 6.0 * cosine + 1.0, rounding);
  EXPECT_NEAR(face_z_mm(cut.face, 52.0, -10.0) - face_z_mm(cut.face, 52.0, 10.0),
              -20.0 * sine / cosine, rounding);
  EXPECT_NEAR(cut.depth_mm, 1.0, rounding);
}

TEST(Plan, ContainsAnAxisThatRunsMedially) {
  Bone bone = block_bone();
  bone.landmarks[1].point_in_bone_mm = Vec3(35.0, 0.0, -15.0);
  const PlannedCut cut = plan_on(silver_with_tilt(0.0), bone).cuts.at(0);
  const double half = std::sqrt(0.5);
  expect_near(cut.axis, Vec3(half, 0.0, -half));
  expect_near(cut.face.normal, Vec3(-half, 0.0, -half));
}

TEST(Plan, DoesNotDependOnWhichEndOfTheAxisIsNamedFirst) {
  Scenario reversed = silver_with_tilt(5.0);
  std::swap(reversed.cuts[0].face.axis_from, reversed.cuts[0].face.axis_to);
  const PlannedCut there = plan_on(silver_with_tilt(5.0), block_bone()).cuts.at(0);
  const PlannedCut back = plan_on(reversed, block_bone()).cuts.at(0);
  expect_near(there.face.normal, back.face.normal);
  expect_near(there.axis, back.axis);
  EXPECT_NEAR(there.face.offset_mm, back.face.offset_mm, rounding);
}

TEST(Plan, WithLateralWasteTiltsTheSameWay) {
  Scenario lateral = silver_with_tilt(5.0);
  lateral.cuts[0].waste_side = "lateral";
  const PlannedCut cut = plan_on(lateral, block_bone()).cuts.at(0);
  expect_near(cut.face.normal, -plan_on(silver_with_tilt(5.0), block_bone()).cuts[0].face.normal);
  EXPECT_LT(face_z_mm(cut.face, 52.0, -10.0), face_z_mm(cut.face, 52.0, 10.0));
  EXPECT_NEAR(cut.depth_mm, 1.0, rounding);
}

TEST(Plan, ThatMissesTheBoneIsRefusedByTheNameOfItsCut) {
  Scenario scenario = silver_with_tilt(0.0);
  scenario.cuts[0].face.offset_mm = 4.5;
  EXPECT_EQ(refusal_of(scenario, block_bone()),
            "silver: cuts[0] \"eminence\": its plane misses the bone \"block\"; mend "
            "face.offset_mm or face.through");
  scenario.cuts[0].face.offset_mm = 3.5;
  EXPECT_EQ(refusal_of(scenario, block_bone()), "");
}

TEST(Plan, NamesTheLandmarkThatTheBoneLacks) {
  Bone bone = block_bone();
  bone.landmarks.erase(bone.landmarks.begin() + 2);
  EXPECT_EQ(refusal_of(silver_with_tilt(5.0), bone),
            "silver: cuts[0] \"eminence\": the bone \"block\" has no landmark \"med_sulcus\"; use "
            "one of: shaft_proximal, shaft_distal, shaft_medial");
}

TEST(Plan, RefusesAnAxisThatGivesNoDirection) {
  Bone bone = block_bone();
  bone.landmarks[1].point_in_bone_mm = bone.landmarks[0].point_in_bone_mm;
  EXPECT_NE(refusal_of(silver_with_tilt(5.0), bone).find("coincide"), std::string::npos);
  bone.landmarks[1].point_in_bone_mm = Vec3(20.0, 0.0, -5.0);
  EXPECT_NE(refusal_of(silver_with_tilt(5.0), bone).find("kept side"), std::string::npos);
}

RC_GTEST_PROP(Plan, AlwaysContainsItsAxisAndKeepsItsDepth, ()) {
  const auto coordinate = [](int low, int high) {
    return static_cast<double>(*rc::gen::inRange(low * 1000, high * 1000)) / 1000.0;
  };
  Bone bone = block_bone();
  bone.landmarks[0].point_in_bone_mm =
      Vec3(coordinate(0, 20), coordinate(-5, 5), coordinate(-5, 5));
  bone.landmarks[1].point_in_bone_mm =
      Vec3(coordinate(40, 60), coordinate(-5, 5), coordinate(-5, 5));
  bone.landmarks[2].point_in_bone_mm =
      Vec3(coordinate(45, 55), coordinate(-5, 5), coordinate(-5, 0));
  const double tilt_deg = coordinate(-20, 20);
  const PlannedCut cut = plan_on(silver_with_tilt(tilt_deg), bone).cuts.at(0);
  RC_ASSERT(std::abs(glm::dot(cut.face.normal, cut.axis)) < rounding);
  RC_ASSERT(std::abs(glm::dot(cut.face.normal, cut.face.normal) - 1.0) < rounding);
  RC_ASSERT(std::abs(cut.depth_mm - 1.0) < rounding);
  RC_ASSERT(cut.axis.x > 0.0 && cut.face.normal.z < 0.0);
}

}  // namespace
}  // namespace hallux::scenarios
