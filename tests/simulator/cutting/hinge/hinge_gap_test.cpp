#include "simulator/cutting/hinge/hinge_gap.h"

#include <gtest/gtest.h>

#include <cmath>

#include "simulator/base/units.h"
#include "tests/simulator/cutting/hinge/notched_block.h"
#include "tests/support/worlds.h"

namespace hallux::tests {
namespace {

using namespace simulator;

/// In the notch's plane x is the block's z + 7 and y is -y: the blade comes from x = 0, the far
/// cortex is x = 14.
RegionOutline opened_to(double dorsal_z_mm, double plantar_z_mm) {
  return {{Vec2(-5.0, -8.0), Vec2(dorsal_z_mm + 7.0, -8.0), Vec2(plantar_z_mm + 7.0, 8.0),
           Vec2(-5.0, 8.0)},
          {4}};
}

Section section_of(const IndexedMesh& mesh, const KerfPlane& plane) {
  return slice_section(uncut_solid(mesh), Bvh(mesh), plane);
}

HingeGap gap_in_block(const RegionOutline& opened, bool looks_distal = true) {
  const Section section =
      section_of(solid_block(Vec3(20.0, 12.0, 14.0)), notch_plane(looks_distal));
  const std::optional<HingeGap> gap = measure_hinge_gap(section, opened, notch_hinge());
  EXPECT_TRUE(gap.has_value());
  return gap.value_or(HingeGap{});
}

TEST(HingeGap, AStraightKerfLeavesWhatItDidNotReach) {
  for (const double tip_mm : {-3.0, 5.2, 6.0, 6.75}) {
    const HingeGap gap = gap_in_block(opened_to(tip_mm, tip_mm));
    EXPECT_NEAR(gap.thickness_mm, 7.0 - tip_mm, 1e-12);
    EXPECT_EQ(gap.over_cut_mm, 0.0);
    EXPECT_TRUE(gap.is_opened);
    EXPECT_NEAR(gap.tip_in_bone_mm.z, tip_mm, 1e-12);
    EXPECT_NEAR(gap.tip_in_bone_mm.x, 0.0, 1e-12);
    EXPECT_NEAR(gap.far_in_bone_mm.z, 7.0, 1e-12);
  }
}

TEST(HingeGap, ARowEveryStepKnowsItsOwnBone) {
  const HingeGap gap = gap_in_block(opened_to(5.0, 6.0));
  ASSERT_EQ(gap.rows.size(), 240U);
  for (const HingeRow& row : gap.rows) {
    // The outline's edge runs from z = 5 at 8 mm dorsal to 6 at 8 mm plantar.
    const double tip_mm = 5.5 - row.along_mm / 16.0;
    EXPECT_NEAR(6.0 + row.tip_mm, tip_mm, 1e-12);
    EXPECT_NEAR(row.intact_mm, 7.0 - tip_mm, 1e-12);
    EXPECT_TRUE(row.is_apex);
  }
  // The last row lies half a step inside the plantar face.
  EXPECT_NEAR(gap.thickness_mm, 7.0 - (5.5 + 5.975 / 16.0), 1e-12);
  EXPECT_NEAR(gap.tip_in_bone_mm.y, -5.975, 1e-12);
}

TEST(HingeGap, TheSideOfTheBladeDoesNotMatter) {
  const HingeGap gap = gap_in_block(opened_to(5.0, 6.0));
  const HingeGap flipped = gap_in_block(opened_to(6.0, 5.0), false);
  EXPECT_NEAR(gap.thickness_mm, flipped.thickness_mm, 1e-12);
  EXPECT_NEAR(glm::distance(gap.tip_in_bone_mm, flipped.tip_in_bone_mm), 0.0, 1e-12);
}

TEST(HingeGap, PastTheCortexItIsOverCutAndTheHingeIsGone) {
  const HingeGap gap = gap_in_block(opened_to(10.1, 10.1));
  EXPECT_EQ(gap.thickness_mm, 0.0);
  EXPECT_NEAR(gap.over_cut_mm, 3.1, 1e-12);
  EXPECT_NEAR(gap.tip_in_bone_mm.z, 10.1, 1e-12);
}

TEST(HingeGap, ANarrowPlungeThroughTheCortexIsABreach) {
  const RegionOutline opened{
      {Vec2(-5.0, -8.0), Vec2(12.0, -8.0), Vec2(12.0, -1.0), Vec2(14.5, -1.0), Vec2(14.5, 1.0),
       Vec2(12.0, 1.0), Vec2(12.0, 8.0), Vec2(-5.0, 8.0)},
      {8}};
  const HingeGap gap = gap_in_block(opened);
  EXPECT_EQ(gap.thickness_mm, 0.0);
  EXPECT_NEAR(gap.over_cut_mm, 0.5, 1e-12);
  EXPECT_LT(std::abs(gap.tip_in_bone_mm.y), 1.0);
}

TEST(HingeGap, BoneThatWasNeverTouchedIsWholeAndSaysSo) {
  const HingeGap gap = gap_in_block({});
  EXPECT_FALSE(gap.is_opened);
  EXPECT_NEAR(gap.thickness_mm, 14.0, 1e-12);
  EXPECT_EQ(gap.over_cut_mm, 0.0);
  // A blade that stayed in the air beside the bone opened a region, but no bone.
  const RegionOutline beside{{Vec2(-5.0, -8.0), Vec2(-1.0, -8.0), Vec2(-1.0, 8.0), Vec2(-5.0, 8.0)},
                             {4}};
  EXPECT_FALSE(gap_in_block(beside).is_opened);
}

TEST(HingeGap, ARoundCortexIsMeasuredWhereItReachesFurthestOut) {
  // A round bone of radius 7 along x. The tip stands at z = 6: in the rows beyond y = 3.6 the line
  // lies outside.
  const IndexedMesh round = hollow_tube(
      {.outer_radius_mm = 7.0, .inner_radius_mm = 0.0, .length_mm = 20.0, .segments = 512});
  const Section section = section_of(round, notch_plane());
  const std::optional<HingeGap> gap =
      measure_hinge_gap(section, opened_to(6.0, 6.0), notch_hinge());
  ASSERT_TRUE(gap.has_value());
  // A corner of the polygon lies at z = 7; the row nearest to it at most half a step beside.
  EXPECT_NEAR(gap->thickness_mm, 1.0, 2e-3);
  EXPECT_NEAR(gap->far_in_bone_mm.y, 0.0, 0.1);
  for (const HingeRow& row : gap->rows) {
    EXPECT_EQ(row.is_apex, std::abs(row.along_mm) < std::sqrt(49.0 - 36.0)) << row.along_mm;
  }
}

TEST(HingeGap, TheCanalIsNotBone) {
  // Outer radius 8, canal 5: a tip in the canal has only the lateral wall beyond it.
  const IndexedMesh tube = hollow_tube({.length_mm = 40.0, .cap_mm = 4.0, .segments = 256});
  const Section section = section_of(tube, notch_plane());
  HingeLine line = notch_hinge();
  line.point_in_bone_mm.z = 7.0;
  const std::optional<HingeGap> gap = measure_hinge_gap(section, opened_to(2.0, 2.0), line);
  ASSERT_TRUE(gap.has_value());
  const HingeRow& middle = gap->rows[gap->rows.size() / 2];
  EXPECT_NEAR(middle.intact_mm, 3.0, 2e-3);
  EXPECT_NEAR(gap->thickness_mm, 3.0, 2e-3);
}

TEST(HingeGap, APlaneAcrossTheHingeOrBesideTheBoneHasNone) {
  const IndexedMesh block = solid_block(Vec3(20.0, 12.0, 14.0));
  KerfPlane across = notch_plane();
  across.bone_from_kerf.rotation = Quat(1.0, 0.0, 0.0, 0.0);
  const RegionOutline opened = opened_to(6.0, 6.0);
  EXPECT_FALSE(measure_hinge_gap(section_of(block, across), opened, notch_hinge()).has_value());
  KerfPlane beside = notch_plane();
  beside.bone_from_kerf.translation_mm.x = 30.0;
  EXPECT_FALSE(measure_hinge_gap(section_of(block, beside), opened, notch_hinge()).has_value());
}

TEST(HingeGap, InATiltedPlaneItIsStillMeasuredOutward) {
  // The plane turned by 20 degrees about y: a tip at z = 6 lies 13 mm / cos 20 from the medial face
  // in it.
  const double tilt_rad = 0.3490658503988659;
  const KerfPlane plane{
      {rotation_about(Vec3(0.0, 1.0, 0.0), tilt_rad) * notch_plane().bone_from_kerf.rotation,
       Vec3(0.0, 0.0, -7.0)},
      0.5};
  const double tip_mm = 13.0 / std::cos(tilt_rad);
  const RegionOutline opened{
      {Vec2(-5.0, -8.0), Vec2(tip_mm, -8.0), Vec2(tip_mm, 8.0), Vec2(-5.0, 8.0)}, {4}};
  const Section section = section_of(solid_block(Vec3(20.0, 12.0, 14.0)), plane);
  const std::optional<HingeGap> gap = measure_hinge_gap(section, opened, notch_hinge());
  ASSERT_TRUE(gap.has_value());
  EXPECT_NEAR(gap->thickness_mm, 1.0, 1e-12);
  EXPECT_NEAR(gap->tip_in_bone_mm.z, 6.0, 1e-12);
  EXPECT_NEAR(std::abs(gap->tip_in_bone_mm.x), 13.0 * std::tan(tilt_rad), 1e-9);
}

TEST(HingeGap, ARigidMotionOfBoneAndPlanesChangesNothing) {
  const RigidTransform motion{rotation_about(Vec3(0.6, 0.0, 0.8), 1.1), Vec3(3.0, -40.0, 12.0)};
  KerfPlane plane = notch_plane();
  plane.bone_from_kerf = motion * plane.bone_from_kerf;
  HingeLine line = notch_hinge();
  line.point_in_bone_mm = transform_point(motion, line.point_in_bone_mm);
  line.axis = transform_direction(motion, line.axis);
  line.outward = transform_direction(motion, line.outward);
  const Section section = section_of(moved(solid_block(Vec3(20.0, 12.0, 14.0)), motion), plane);
  const std::optional<HingeGap> gap = measure_hinge_gap(section, opened_to(5.0, 6.0), line);
  ASSERT_TRUE(gap.has_value());
  EXPECT_NEAR(gap->thickness_mm, gap_in_block(opened_to(5.0, 6.0)).thickness_mm, 1e-9);
}

}  // namespace
}  // namespace hallux::tests
