#include "simulator/cutting/hinge/hinge.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "simulator/base/random.h"
#include "simulator/cutting/solid/commit_patch.h"
#include "tests/simulator/cutting/hinge/notched_block.h"
#include "tests/simulator/cutting/worlds/cut_through.h"
#include "tests/support/worlds.h"

namespace hallux::tests {
namespace {

using namespace simulator;

double volume_mm3(const CutSolid& solid) { return signed_volume_mm3(solid.mesh); }

void expect_lossless(const CutSolid& solid, const KerfPlane& plane) {
  const DividedBone divided = divide_at_hinge(solid, Bvh(solid.mesh), plane);
  expect_closed(divided.above);
  expect_closed(divided.below);
  EXPECT_EQ(split_pieces(divided.above).size(), 1U);
  EXPECT_EQ(split_pieces(divided.below).size(), 1U);
  EXPECT_GT(volume_mm3(divided.above), 0.0);
  EXPECT_GT(volume_mm3(divided.below), 0.0);
  EXPECT_NEAR(volume_mm3(divided.above) + volume_mm3(divided.below), volume_mm3(solid),
              1e-12 * volume_mm3(solid));
}

HingeGap gap_of(double thickness_mm) {
  HingeGap gap;
  gap.thickness_mm = thickness_mm;
  gap.tip_in_bone_mm = gap.middle_in_bone_mm = Vec3(0.0, 0.0, 7.0 - thickness_mm);
  gap.is_opened = true;
  return gap;
}

HingeRequest request_for(const Notch& notch) {
  HingeRequest request;
  request.first = notch_plane();
  request.second = upper_plane(notch);
  request.first_gap = gap_of(7.0 - notch.tip_z_mm);
  request.second_gap = gap_of(7.0 - notch.tip_z_mm + 0.5);
  request.bridge.line = notch_hinge();
  return request;
}

ClosedHinge closed(const Notch& notch) {
  const CutSolid solid = notched_block(notch);
  return close_hinge(solid, Bvh(solid.mesh), request_for(notch));
}

/// How deep the moved body, turned by `angle_rad`, stands in the fixed one outside the bridge.
double deepest_overlap_mm(const ClosedHinge& hinge, double angle_rad, double parts = 24.0) {
  const Bvh fixed(hinge.fixed.mesh);
  RigidTransform turn{rotation_about(hinge.joint.axis, angle_rad), Vec3(0.0)};
  turn.translation_mm = hinge.joint.point_mm - transform_direction(turn, hinge.joint.point_mm);
  double deepest_mm = 0.0;
  for (const Triangle& corners : hinge.moved.mesh.triangles) {
    const Vec3& a = hinge.moved.mesh.points_mm[corners[0]];
    const Vec3& b = hinge.moved.mesh.points_mm[corners[1]];
    const Vec3& c = hinge.moved.mesh.points_mm[corners[2]];
    for (double i = 0.0; i <= parts; i += 1.0) {
      for (double j = 0.0; i + j <= parts; j += 1.0) {
        const Vec3 at = a + (i / parts) * (b - a) + (j / parts) * (c - a);
        const Vec3 across = glm::cross(at - hinge.joint.point_mm, hinge.joint.axis);
        if (glm::length(across) <= hinge.bridge_radius_mm) continue;
        deepest_mm = std::max(deepest_mm, -fixed.signed_distance_mm(transform_point(turn, at)));
      }
    }
  }
  return deepest_mm;
}

TEST(Hinge, DividingLosesNothing) {
  expect_lossless(notched_block({}), notch_plane());
  expect_lossless(notched_block({}), notch_plane(false));
  expect_lossless(notched_block({.dorsal_rise = 0.03}), notch_plane());
}

TEST(Hinge, DividingLosesNothingWhateverThePlaneMeets) {
  const CutSolid tube = uncut_solid(hollow_tube({.rings = 8}));
  const CutSolid ball = uncut_solid(sphere(9.0, 12));
  for (const double offset_mm : {0.0, 3.75, -7.5, 1.234}) {
    expect_lossless(tube, axis_plane(0, offset_mm, 0.5));  // 0, 3.75 and -7.5 are rings of corners
    expect_lossless(tube, plane_through(Vec3(offset_mm, 0.0, 0.0), Vec3(0.9, 0.2, -0.3), 0.5));
    expect_lossless(ball, plane_through(Vec3(0.5 * offset_mm), Vec3(0.3, -0.8, 0.5), 0.5));
  }
  expect_lossless(ball, axis_plane(1, 0.0, 0.5));
}

TEST(Hinge, TheFacesOfTheDivisionAreNotWallsOfAKerf) {
  const CutSolid solid = notched_block({});
  const DividedBone divided = divide_at_hinge(solid, Bvh(solid.mesh), notch_plane());
  ASSERT_EQ(divided.bridges_mm2.size(), 1U);
  EXPECT_NEAR(divided.bridges_mm2[0], 12.0, 1e-12);
  for (const CutSolid* half : {&divided.above, &divided.below}) {
    double area_mm2 = 0.0;
    for (std::size_t i = 0; i < half->sources.size(); ++i) {
      if (half->sources[i].kerf != hinge_face) continue;
      const Triangle& corners = half->mesh.triangles[i];
      const Vec3& a = half->mesh.points_mm[corners[0]];
      area_mm2 += 0.5 * glm::length(glm::cross(half->mesh.points_mm[corners[1]] - a,
                                               half->mesh.points_mm[corners[2]] - a));
    }
    EXPECT_NEAR(area_mm2, 12.0, 1e-12);
  }
}

TEST(Hinge, AWedgeClosesUntilItsFacesTouch) {
  const ClosedHinge hinge = closed({});
  ASSERT_EQ(hinge.outcome, HingeOutcome::Closed);
  // The lower wall ends 13 mm from the joint and 0.25 mm below it; there the upper wall arrives.
  // Seen from the joint its point at the same radius lies at (c, 0.25 + rise (c - 2.8)) with c^2 +
  // n^2 = 13^2 + 0.25^2.
  const double rise = Notch{}.rise, radius_mm2 = 13.0 * 13.0 + 0.25 * 0.25;
  const double base_mm = 0.25 - rise * 2.8;
  const double b = rise * base_mm, a = 1.0 + rise * rise;
  const double c_mm = (-b + std::sqrt(b * b - a * (base_mm * base_mm - radius_mm2))) / a;
  const double expected_rad = std::atan2(base_mm + rise * c_mm, c_mm) + std::atan2(0.25, 13.0);
  EXPECT_NEAR(hinge.angle_rad, expected_rad, 1e-12);
  EXPECT_NEAR(glm::length(hinge.contact_in_bone_mm - Vec3(-0.25, hinge.contact_in_bone_mm.y, -7.0)),
              0.0, 1e-9);
  EXPECT_NEAR(hinge.bridge_radius_mm, 1.0 + 0.5, 1e-12);
  EXPECT_NEAR(volume_mm3(hinge.fixed) + volume_mm3(hinge.moved), volume_mm3(notched_block({})),
              1e-9);
  // The distal half is the one that moves, and it moves towards the base.
  EXPECT_LT(transform_point(hinge.bone_from_moved, Vec3(10.0, 0.0, -7.0)).x, 10.0);
}

TEST(Hinge, TheOrderAndTheSideOfTheKerfsDoNotMatter) {
  const CutSolid solid = notched_block({});
  HingeRequest request = request_for({});
  const ClosedHinge first = close_hinge(solid, Bvh(solid.mesh), request);
  std::swap(request.first, request.second);
  std::swap(request.first_gap, request.second_gap);
  const ClosedHinge swapped = close_hinge(solid, Bvh(solid.mesh), request);
  EXPECT_EQ(swapped.angle_rad, first.angle_rad);
  request.second = notch_plane(false);
  const ClosedHinge flipped = close_hinge(solid, Bvh(solid.mesh), request);
  EXPECT_NEAR(flipped.angle_rad, first.angle_rad, 1e-12);
  EXPECT_NEAR(volume_mm3(flipped.moved), volume_mm3(first.moved), 1e-9);
}

TEST(Hinge, TheOtherHalfMayTurnInstead) {
  const CutSolid solid = notched_block({});
  HingeRequest request = request_for({});
  request.bridge.toward_moved = Vec3(-1.0, 0.0, 0.0);
  const ClosedHinge hinge = close_hinge(solid, Bvh(solid.mesh), request);
  ASSERT_EQ(hinge.outcome, HingeOutcome::Closed);
  EXPECT_NEAR(hinge.angle_rad, closed({}).angle_rad, 1e-9);
  EXPECT_GT(transform_point(hinge.bone_from_moved, Vec3(-10.0, 0.0, -7.0)).x, -10.0);
}

TEST(Hinge, BodiesOverlapOnlyInsideTheBridge) {
  Random random(20260731);
  int tilted = 0;
  for (int i = 0; i < 12; ++i) {
    const Notch notch{.tip_z_mm = random.uniform(4.8, 6.6),
                      .kink_z_mm = random.uniform(-1.0, 4.0),
                      .rise = random.uniform(0.05, 0.35),
                      .dorsal_rise = random.uniform(-0.02, 0.02)};
    const ClosedHinge hinge = closed(notch);
    ASSERT_EQ(hinge.outcome, HingeOutcome::Closed);
    EXPECT_LT(deepest_overlap_mm(hinge, hinge.angle_rad), 1e-6);
    // A tenth of a degree more and they do overlap: the turn was not stopped too early.
    EXPECT_GT(deepest_overlap_mm(hinge, hinge.angle_rad + 2e-3), 1e-5);
    tilted += std::abs(hinge.joint.axis.z) > 0.02 ? 1 : 0;
  }
  EXPECT_GT(tilted, 0);
}

TEST(Hinge, ALeaningWedgeTouchesAtOneEnd) {
  const ClosedHinge hinge = closed({.dorsal_rise = 0.03});
  ASSERT_EQ(hinge.outcome, HingeOutcome::Closed);
  EXPECT_LT(hinge.angle_rad, closed({}).angle_rad + 0.05);
  EXPECT_LT(deepest_overlap_mm(hinge, hinge.angle_rad), 1e-6);
}

/// A bone of radius 7.5 with a canal, sawn from medial (-z) along two faces that meet at z = 6.5.
struct SawnTube {
  CutSolid whole = uncut_solid(hollow_tube({.outer_radius_mm = 7.5,
                                            .inner_radius_mm = 4.0,
                                            .length_mm = 30.0,
                                            .cap_mm = 3.0,
                                            .rings = 10}));
  std::vector<CutSolid> pieces;
  HingeRequest request;
};

/// The blade's middle plane half a kerf on the waste side (+1 along the normal) of the face through
/// the hinge's line.
KerfPlane kerf_beside_face(double tilt_rad, double lean_rad, double waste_side) {
  const Quat turn = rotation_about(Vec3(0.0, 0.0, 1.0), lean_rad) *
                    rotation_about(Vec3(0.0, 1.0, 0.0), -tilt_rad);
  const Vec3 normal = turn * Vec3(1.0, 0.0, 0.0), feed = turn * Vec3(0.0, 0.0, 1.0);
  return {{rotation_from_axes(feed, glm::cross(normal, feed)),
           Vec3(0.0, 0.0, 6.5) + 0.25 * waste_side * normal},
          0.5};
}

SawnTube sawn_tube(double lean_rad, double reach_mm = 8.0) {
  SawnTube tube;
  tube.request.first = kerf_beside_face(0.0, 0.0, 1.0);
  tube.request.second = kerf_beside_face(10.0 * pi / 180.0, lean_rad, -1.0);
  tube.request.bridge.line = notch_hinge();
  tube.request.bridge.line.point_in_bone_mm = Vec3(0.0, 0.0, 6.5);
  // Feed ends at the hinge; from 2.5 to 4.5 mm before it the blade reached only to `reach_mm` on
  // one side.
  const RegionOutline opened{
      {Vec2(-20.0, -9.0), Vec2(0.0, -9.0), Vec2(0.0, 9.0), Vec2(-2.5, 9.0), Vec2(-2.5, reach_mm),
       Vec2(-4.5, reach_mm), Vec2(-4.5, 9.0), Vec2(-20.0, 9.0)},
      {8}};
  CutSolid solid = tube.whole;
  std::int32_t kerf = 0;
  for (const auto& [plane, gap] : {std::pair(&tube.request.first, &tube.request.first_gap),
                                   std::pair(&tube.request.second, &tube.request.second_gap)}) {
    const Section section = slice_section(tube.whole, Bvh(tube.whole.mesh), *plane);
    *gap = measure_hinge_gap(section, opened, tube.request.bridge.line).value();
    solid = cut_kerf(solid, Bvh(solid.mesh), *plane, kerf++, FieldGrid{}, opened).solid;
  }
  tube.pieces = split_pieces(solid);
  return tube;
}

TEST(Hinge, AWedgeSawnFromABoneWithACanalCloses) {
  for (const double lean_rad : {0.0, 0.03, -0.05}) {
    const SawnTube tube = sawn_tube(lean_rad);
    ASSERT_GE(tube.pieces.size(), 2U);
    const CutSolid& bone = tube.pieces.front();
    const ClosedHinge hinge = close_hinge(bone, Bvh(bone.mesh), tube.request);
    ASSERT_EQ(hinge.outcome, HingeOutcome::Closed);
    expect_closed(hinge.fixed);
    expect_closed(hinge.moved);
    EXPECT_NEAR(volume_mm3(hinge.fixed) + volume_mm3(hinge.moved), volume_mm3(bone), 1e-9);
    EXPECT_NEAR(hinge.thickness_mm, 1.0, 0.01);
    // The joint runs along the line in which the planes meet, so the faces come to lie flat on each
    // other: at the angle between them, but that the joint stands half a kerf in the gap; 13 mm
    // away that is less than 0.1 degree.
    const Vec3 up(0.0, 0.0, 1.0);
    const Vec3 first = tube.request.first.bone_from_kerf.rotation * up;
    const Vec3 second = tube.request.second.bone_from_kerf.rotation * up;
    EXPECT_NEAR(hinge.angle_rad, std::acos(glm::dot(first, second)), 0.1 * pi / 180.0);
    EXPECT_LT(deepest_overlap_mm(hinge, hinge.angle_rad, 3.0), 1e-6);
    EXPECT_GT(deepest_overlap_mm(hinge, hinge.angle_rad + 2e-3, 3.0), 1e-5);
  }
}

TEST(Hinge, AStripThatTheBladeMissedBreaksOrHolds) {
  const auto closed_with_reach = [](double reach_mm) {
    const SawnTube tube = sawn_tube(0.0, reach_mm);
    const CutSolid& bone = tube.pieces.front();
    return close_hinge(bone, Bvh(bone.mesh), tube.request);
  };
  // At 4.5 mm before the hinge the bone reaches to 7.23 mm. The bridge itself has 5 mm2.
  const ClosedHinge thin = closed_with_reach(6.9);  // 0.15 mm2 are left
  ASSERT_EQ(thin.outcome, HingeOutcome::Closed);
  EXPECT_NEAR(thin.angle_rad, 10.0 * pi / 180.0, 0.1 * pi / 180.0);
  EXPECT_GT(thin.bridge_radius_mm, 4.0);
  EXPECT_EQ(closed_with_reach(5.0).outcome, HingeOutcome::Stiff);  // 3.7 mm2
}

TEST(Hinge, TooThinBreaksAndTooThickDoesNotBend) {
  const CutSolid solid = notched_block({});
  HingeRequest request = request_for({});
  const auto outcome_at = [&](double first_mm, double second_mm) {
    request.first_gap.thickness_mm = first_mm;
    request.second_gap.thickness_mm = second_mm;
    return close_hinge(solid, Bvh(solid.mesh), request).outcome;
  };
  EXPECT_EQ(outcome_at(0.29, 1.0), HingeOutcome::Broken);
  EXPECT_EQ(outcome_at(1.0, 0.0), HingeOutcome::Broken);
  EXPECT_EQ(outcome_at(0.3, 1.0), HingeOutcome::Closed);
  EXPECT_EQ(outcome_at(2.5, 9.0), HingeOutcome::Closed);
  EXPECT_EQ(outcome_at(2.51, 9.0), HingeOutcome::Stiff);
}

TEST(Hinge, WithoutAGapNearEnoughThereIsNothingToClose) {
  const CutSolid solid = notched_block({});
  HingeRequest request = request_for({});
  request.most_rad = 0.1;
  EXPECT_EQ(close_hinge(solid, Bvh(solid.mesh), request).outcome, HingeOutcome::FacesMissing);
}

}  // namespace
}  // namespace hallux::tests
