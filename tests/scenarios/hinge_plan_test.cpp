// The plan of two faces that meet at a hinge, on bones whose sections can be computed by hand.
#include <gtest/gtest.h>

#include <cmath>

#include "scenarios/plan.h"
#include "simulator/base/units.h"
#include "tests/scenarios/format_1/format_1.h"
#include "tests/support/worlds.h"

namespace hallux::scenarios {
namespace {

using simulator::Bone;

/// Each value below is a handful of roundings of numbers under 100.
constexpr double rounding = 1.0e-12;

/// From x = 0 to 33 mm, with the joint's line along z unless `base_med_x_mm` turns it.
Bone phalanx(const simulator::IndexedMesh& centred, double base_med_x_mm = 0.0) {
  Bone bone;
  bone.name = "stand_in";
  bone.outer = tests::moved(centred, {{}, {16.5, 0.0, 0.0}});
  bone.landmarks = {{"base_centre", Vec3(0.0, 0.0, 0.0)},
                    {"base_med", Vec3(base_med_x_mm, 0.0, -7.5)},
                    {"base_lat", Vec3(0.0, 0.0, 7.5)},
                    {"ip_centre", Vec3(33.0, 0.0, 0.0)}};
  return bone;
}

/// 13 mm from plantar to dorsal and 15 mm from medial to lateral.
Bone block() { return phalanx(tests::solid_block({33.0, 13.0, 15.0})); }

/// An elliptic cylinder of 15 x 12.5 mm, as in the worked example: corners on the axes.
Bone cylinder() {
  simulator::IndexedMesh mesh =
      tests::hollow_tube({.outer_radius_mm = 7.5, .inner_radius_mm = 0.0, .length_mm = 33.0});
  for (Vec3& point : mesh.points_mm) point.y *= 6.25 / 7.5;
  return phalanx(mesh);
}

std::string refusal_of(const Scenario& scenario, const Bone& bone) {
  try {
    plan_on(scenario, bone);
  } catch (const ScenarioError& error) {
    return error.what();
  }
  return "";
}

void expect_near(const Vec3& a, const Vec3& b, double tolerance) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
  EXPECT_NEAR(a.z, b.z, tolerance);
}

TEST(HingePlan, OnTheWorkedExamplesSectionHasItsPlanes) {
  const Plan plan = plan_on(scenarios_test::format_1("akin"), cylinder());
  // The example rounds to three and four decimals.
  const ReferenceFace& first = plan.cuts.at(0).face;
  expect_near(first.normal, Vec3(1.0, 0.0, 0.0), rounding);
  EXPECT_NEAR(first.offset_mm, 6.0, rounding);
  const ReferenceFace& second = plan.cuts.at(1).face;
  expect_near(second.normal, -Vec3(0.9848, 0.0, 0.1736), 1.0e-4);
  EXPECT_NEAR(second.offset_mm, -7.038, 1.0e-3);
  // The gap at the medial cortex.
  const double base_mm = (7.038 + 0.1736 * 7.5) / 0.9848 - 6.0;
  EXPECT_NEAR(base_mm, 2.469, 1.0e-3);
  EXPECT_NEAR(plan.cuts[1].entry_point_in_bone_mm.x - plan.cuts[0].entry_point_in_bone_mm.x,
              base_mm, 1.0e-3);
}

TEST(HingePlan, PutsTheLineItsThicknessInsideTheFarCortex) {
  for (const Bone& bone : {block(), cylinder()}) {
    const Plan plan = plan_on(scenarios_test::format_1("akin"), bone);
    ASSERT_EQ(plan.hinges.size(), 1U);
    const PlannedHinge& hinge = plan.hinges[0];
    EXPECT_NEAR(hinge.bridge.line.point_in_bone_mm.x, 6.0, rounding);
    EXPECT_NEAR(hinge.bridge.line.point_in_bone_mm.z, 6.5, rounding);
    expect_near(hinge.bridge.line.axis, Vec3(0.0, 1.0, 0.0), rounding);
    expect_near(hinge.bridge.line.outward, Vec3(0.0, 0.0, 1.0), rounding);
    EXPECT_NEAR(hinge.wedge_rad, radian_from_degree(10.0), rounding);
  }
}

TEST(HingePlan, GivesBothFacesTheLineAndTheirWasteBetweenThem) {
  const Plan plan = plan_on(scenarios_test::format_1("akin"), block());
  const PlannedHinge& hinge = plan.hinges.at(0);
  for (const PlannedCut& cut : plan.cuts) {
    EXPECT_EQ(cut.hinge, hinge.name);
    for (const double along_mm : {-5.0, 5.0}) {
      const Vec3 point = hinge.bridge.line.point_in_bone_mm + along_mm * hinge.bridge.line.axis;
      EXPECT_NEAR(glm::dot(cut.face.normal, point), cut.face.offset_mm, rounding);
    }
    // In the middle of the wedge, 10 mm from the line.
    const Vec3 inside =
        hinge.bridge.line.point_in_bone_mm - 10.0 * hinge.bridge.line.outward + Vec3(0.5, 0.0, 0.0);
    EXPECT_GT(glm::dot(cut.face.normal, inside), cut.face.offset_mm);
    expect_near(cut.exit_point_in_bone_mm, hinge.bridge.line.point_in_bone_mm, rounding);
    EXPECT_NEAR(cut.entry_point_in_bone_mm.z, -7.5, rounding);
  }
  EXPECT_EQ(find_cut(plan, "distal_face"), &plan.cuts[1]);
  EXPECT_EQ(find_cut(plan, "third"), nullptr);
  EXPECT_EQ(find_hinge(plan, "lateral_hinge"), &hinge);
  EXPECT_EQ(find_hinge(plan, ""), nullptr);
}

TEST(HingePlan, FollowsAnObliqueJointLine) {
  // 1.5 mm over 15: the medial end of the joint lies further distal.
  const Plan plan = plan_on(scenarios_test::format_1("akin"),
                            phalanx(tests::solid_block({33.0, 13.0, 15.0}), 1.5));
  const Vec3 joint = Vec3(1.5, 0.0, -7.5) - Vec3(0.0, 0.0, 7.5);
  const ReferenceFace& first = plan.cuts.at(0).face;
  EXPECT_NEAR(glm::dot(first.normal, joint), 0.0, rounding);
  EXPECT_NEAR(first.normal.z / first.normal.x, 0.1, rounding);
  EXPECT_NEAR(first.offset_mm, 6.0 * first.normal.x, rounding);
  EXPECT_NEAR(-glm::dot(first.normal, plan.cuts[1].face.normal), std::cos(radian_from_degree(10.0)),
              rounding);
}

TEST(HingePlan, TiltsAFaceAsTheFormatSays) {
  Scenario akin = scenarios_test::format_1("akin");
  akin.cuts[0].face.transverse_tilt_rad = radian_from_degree(5.0);
  akin.cuts[0].face.sagittal_tilt_rad = radian_from_degree(-7.0);
  const Vec3 normal = plan_on(akin, block()).cuts.at(0).face.normal;
  EXPECT_NEAR(std::atan2(normal.z, normal.x), radian_from_degree(5.0), rounding);
  EXPECT_NEAR(std::atan2(normal.y, normal.x), radian_from_degree(-7.0), rounding);
  EXPECT_NEAR(glm::dot(normal, normal), 1.0, rounding);
}

TEST(HingePlan, OnTheMedialSideIsItsMirrorImage) {
  Scenario mirrored = scenarios_test::format_1("akin");
  mirrored.hinges[0].side = "medial";
  for (ReferenceCut& cut : mirrored.cuts) cut.approach = "lateral";
  const Plan there = plan_on(scenarios_test::format_1("akin"), cylinder());
  const Plan here = plan_on(mirrored, cylinder());
  const auto mirror = [](const Vec3& v) { return Vec3(v.x, v.y, -v.z); };
  expect_near(here.hinges.at(0).bridge.line.point_in_bone_mm,
              mirror(there.hinges.at(0).bridge.line.point_in_bone_mm), rounding);
  for (std::size_t i = 0; i < 2; ++i) {
    expect_near(here.cuts[i].face.normal, mirror(there.cuts[i].face.normal), rounding);
    EXPECT_NEAR(here.cuts[i].face.offset_mm, there.cuts[i].face.offset_mm, rounding);
  }
}

TEST(HingePlan, WithoutRoomInTheBoneIsRefused) {
  const Bone thin = phalanx(tests::solid_block({33.0, 13.0, 1.9}));
  EXPECT_EQ(refusal_of(scenarios_test::format_1("akin"), thin),
            "akin: hinges[0] \"lateral_hinge\": the bone \"stand_in\" is too thin for it; mend "
            "thickness_mm or the face of \"proximal_face\"");
  Scenario missing = scenarios_test::format_1("akin");
  missing.cuts[0].face.offset_mm = -1.0;
  EXPECT_NE(refusal_of(missing, block()).find("cuts[0] \"proximal_face\": its plane misses"),
            std::string::npos);
}

}  // namespace
}  // namespace hallux::scenarios
