#include "simulator/cutting/solid/remove_slab.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "simulator/cutting/slice/plane_slice.h"
#include "simulator/cutting/solid/slab_volume.h"
#include "tests/simulator/cutting/worlds/cut_through.h"
#include "tests/support/worlds.h"

namespace hallux::tests {
namespace {

using namespace simulator;

/// Corners of circles are on the radius, so a tube's section is a regular polygon.
double polygon_area_mm2(double radius_mm, std::size_t segments) {
  const double angle_rad = 2.0 * 3.14159265358979323846 / static_cast<double>(segments);
  return 0.5 * static_cast<double>(segments) * radius_mm * radius_mm * std::sin(angle_rad);
}

CutSolid block() { return uncut_solid(solid_block(Vec3(30.0, 14.0, 12.0))); }

TEST(Cut, ABlockLosesItsSectionTimesTheKerf) {
  const CutOutcome cut = cut_through(block(), axis_plane(0, 3.25, 0.5));
  expect_closed(cut.solid);
  EXPECT_NEAR(cut.removed_mm3, 14.0 * 12.0 * 0.5, 1e-12 * 84.0);
  ASSERT_EQ(cut.section.regions.size(), 1U);
  EXPECT_NEAR(cut.section.regions[0].area_mm2, 168.0, 1e-12 * 168.0);
  const std::vector<CutSolid> pieces = split_pieces(cut.solid);
  ASSERT_EQ(pieces.size(), 2U);
  EXPECT_NEAR(signed_volume_mm3(pieces[0].mesh), (15.0 + 3.0) * 168.0, 1e-11 * 3024.0);
  EXPECT_NEAR(signed_volume_mm3(pieces[1].mesh), (15.0 - 3.5) * 168.0, 1e-11 * 1932.0);
}

TEST(Cut, AnObliqueKerfTakesTheAreaOfItsSectionTimesItsThickness) {
  // The section of a long prism is the same at every height: area / cos(tilt).
  const Vec3 normal(0.8, 0.6, 0.0);
  const CutOutcome cut = cut_through(block(), plane_through(Vec3(0.0), normal, 0.4));
  expect_closed(cut.solid);
  expect_balance(block(), cut);
  EXPECT_NEAR(cut.removed_mm3, 14.0 * 12.0 / 0.8 * 0.4, 1e-11 * 84.0);
}

TEST(Cut, ATubeLosesARing) {
  const Tube tube{.outer_radius_mm = 8.0, .inner_radius_mm = 5.0, .length_mm = 60.0, .rings = 7};
  const CutSolid solid = uncut_solid(hollow_tube(tube));
  const CutOutcome cut = cut_through(solid, axis_plane(0, 1.3, 0.5));
  expect_closed(cut.solid);
  expect_balance(solid, cut);
  ASSERT_EQ(cut.section.regions.size(), 1U);
  EXPECT_EQ(cut.section.regions[0].contours.size(), 2U);
  const double ring_mm2 = polygon_area_mm2(8.0, 64) - polygon_area_mm2(5.0, 64);
  EXPECT_NEAR(cut.section.regions[0].area_mm2, ring_mm2, 1e-11 * ring_mm2);
  EXPECT_NEAR(cut.removed_mm3, 0.5 * ring_mm2, 1e-11 * ring_mm2);
  // The canal opens: two pieces of one shell each.
  EXPECT_EQ(split_pieces(cut.solid).size(), 2U);
}

TEST(Cut, ATubesWallLeavesTheCanalOpen) {
  const CutSolid solid = uncut_solid(hollow_tube({.rings = 5}));
  const CutOutcome cut = cut_through(solid, axis_plane(0, 0.7, 0.5));
  double wall_mm2 = 0.0;
  const double inner_mm = 5.0 * std::cos(3.14159265358979323846 / 64.0);
  for (std::size_t i = 0; i < cut.solid.mesh.triangles.size(); ++i) {
    if (cut.solid.sources[i].kerf != 0 || cut.solid.sources[i].side != 1) continue;
    const Triangle& corners = cut.solid.mesh.triangles[i];
    const Vec3& a = cut.solid.mesh.points_mm[corners[0]];
    const Vec3& b = cut.solid.mesh.points_mm[corners[1]];
    const Vec3& c = cut.solid.mesh.points_mm[corners[2]];
    const Vec3 middle = (a + b + c) / 3.0;
    EXPECT_GE(std::sqrt(middle.y * middle.y + middle.z * middle.z), inner_mm - 1e-9);
    EXPECT_LE(glm::cross(b - a, c - a).x, 1e-12);  // looks down into the kerf
    wall_mm2 += 0.5 * glm::length(glm::cross(b - a, c - a));
  }
  const double ring_mm2 = polygon_area_mm2(8.0, 64) - polygon_area_mm2(5.0, 64);
  EXPECT_NEAR(wall_mm2, ring_mm2, 1e-9 * ring_mm2);
}

TEST(Cut, ATubeSlitAlongItsLengthStaysTwoHalves) {
  const CutSolid solid = uncut_solid(hollow_tube({.rings = 9}));
  const CutOutcome cut = cut_through(solid, axis_plane(1, 0.0, 0.5));
  expect_closed(cut.solid);
  expect_balance(solid, cut);
  EXPECT_EQ(split_pieces(cut.solid).size(), 2U);
}

TEST(Cut, AKerfThatSkimsTheCanalCloses) {
  const CutSolid solid = uncut_solid(hollow_tube({.segments = 32, .rings = 9}));
  for (const double offset_mm : {5.25, 5.0, 4.75, 5.24, 4.76, 8.0, 7.75, 8.25}) {
    for (const std::size_t axis : {1U, 2U}) {
      const CutOutcome cut = cut_through(solid, axis_plane(axis, offset_mm, 0.5));
      expect_closed(cut.solid);
      expect_balance(solid, cut);
    }
  }
}

TEST(Cut, BothArmsOfAUAreRegionsOfTheirOwn) {
  const CutSolid solid = uncut_solid(u_shape(Vec3(30.0, 20.0, 8.0), 6.0));
  const CutOutcome cut = cut_through(solid, axis_plane(1, 5.0, 0.5));
  expect_closed(cut.solid);
  EXPECT_EQ(cut.section.regions.size(), 2U);
  EXPECT_NEAR(cut.removed_mm3, 2.0 * 6.0 * 8.0 * 0.5, 1e-10);
  EXPECT_EQ(split_pieces(cut.solid).size(), 3U);
}

TEST(Cut, ACutAcrossAUTakesOneArmAndLeavesTheOtherUntouched) {
  const CutSolid solid = uncut_solid(u_shape(Vec3(30.0, 20.0, 8.0), 6.0));
  const KerfPlane plane = axis_plane(1, 5.0, 0.5);
  const Bvh bvh(solid.mesh);
  const Section section = slice_section(solid, bvh, plane);
  ASSERT_EQ(section.regions.size(), 2U);
  const std::vector<std::uint8_t> first_only{1, 0};
  const CutSolid cut = remove_slab(solid, bvh, section, 3, first_only);
  expect_closed(cut);
  EXPECT_EQ(split_pieces(cut).size(), 2U);
  EXPECT_NEAR(signed_volume_mm3(solid.mesh) - signed_volume_mm3(cut.mesh), 24.0, 1e-10);
  EXPECT_NEAR(slab_volume_mm3(solid, section, first_only), 24.0, 1e-10);
  // Triangles that were not touched come first, in their order, with the same bits.
  std::size_t at = 0;
  for (std::uint32_t i = 0; i < solid.mesh.triangles.size(); ++i) {
    const auto& touched = section.regions[0].triangles;
    if (std::binary_search(touched.begin(), touched.end(), i)) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(cut.mesh.points_mm[cut.mesh.triangles[at][k]],
                solid.mesh.points_mm[solid.mesh.triangles[i][k]]);
    }
    EXPECT_EQ(cut.sources[at++], FaceSource{});
  }
}

TEST(Cut, TheFloorOfAUIsOneRegion) {
  const CutSolid solid = uncut_solid(u_shape(Vec3(30.0, 20.0, 8.0), 6.0));
  const CutOutcome cut = cut_through(solid, axis_plane(2, 1.0, 0.5));
  expect_closed(cut.solid);
  EXPECT_EQ(cut.section.regions.size(), 1U);
  EXPECT_NEAR(cut.removed_mm3, (30.0 * 20.0 - 18.0 * 14.0) * 0.5, 1e-10);
}

TEST(Cut, APlaneThatMissesChangesNothing) {
  const CutOutcome cut = cut_through(block(), axis_plane(0, 40.0, 0.5));
  EXPECT_TRUE(cut.section.regions.empty());
  EXPECT_EQ(cut.removed_mm3, 0.0);
  EXPECT_EQ(cut.solid.mesh, block().mesh);
}

TEST(Cut, PlanesThroughCornersEdgesAndFacesClose) {
  // With 0.5 mm kerfs at these offsets the planes meet the faces, and the middle planes the
  // corners, exactly.
  for (const std::size_t axis : {0U, 1U, 2U}) {
    const double half_mm = std::array{15.0, 7.0, 6.0}[axis];
    const double across_mm2 = std::array{168.0, 360.0, 420.0}[axis];
    const auto taken_mm = [](double low, double high) { return std::max(0.0, high - low); };
    for (const double offset_mm :
         {-half_mm - 0.25, -half_mm, -half_mm + 0.25, half_mm - 0.25, half_mm, half_mm + 0.25}) {
      const CutOutcome cut = cut_through(block(), axis_plane(axis, offset_mm, 0.5));
      expect_closed(cut.solid);
      const double expected_mm3 = across_mm2 * taken_mm(std::max(-half_mm, offset_mm - 0.25),
                                                        std::min(half_mm, offset_mm + 0.25));
      EXPECT_NEAR(cut.removed_mm3, expected_mm3, 1e-10);
      EXPECT_NEAR(signed_volume_mm3(cut.solid.mesh), 5040.0 - expected_mm3, 1e-9);
    }
  }
}

TEST(Cut, ADiagonalPlaneThroughEdgesCloses) {
  const CutSolid cube = uncut_solid(solid_block(Vec3(10.0)));
  for (const Vec3& normal : {Vec3(1.0, 1.0, 0.0), Vec3(1.0, -1.0, 0.0), Vec3(1.0, 1.0, 1.0),
                             Vec3(1.0, 0.0, -1.0), Vec3(-1.0, 1.0, 1.0)}) {
    for (const double thickness_mm : {0.5, 1.0, 3.0}) {
      for (const double shift_mm : {0.0, 0.5, -0.5, 1.5, -1.5, 0.25}) {
        const Vec3 unit = normal / std::sqrt(glm::dot(normal, normal));
        const CutOutcome cut =
            cut_through(cube, plane_through(shift_mm * unit, normal, thickness_mm));
        expect_closed(cut.solid);
        expect_balance(cube, cut);
      }
    }
  }
}

TEST(Cut, ABlockThinnerThanTheKerfGoesWhole) {
  const CutSolid sheet = uncut_solid(solid_block(Vec3(10.0, 8.0, 0.3)));
  const CutOutcome cut = cut_through(sheet, axis_plane(2, 0.0, 0.5));
  EXPECT_NEAR(cut.removed_mm3, 24.0, 1e-11);
  EXPECT_TRUE(cut.solid.mesh.triangles.empty());
  EXPECT_TRUE(split_pieces(cut.solid).empty());
}

TEST(Cut, AVoidInsideTheSlabGoesWithTheBoneAroundIt) {
  IndexedMesh mesh = solid_block(Vec3(10.0));
  append_mesh(mesh, inside_out(solid_block(Vec3(1.0, 1.0, 0.2))));
  const CutSolid solid = uncut_solid(mesh);
  const CutOutcome cut = cut_through(solid, axis_plane(2, 0.0, 0.5));
  expect_closed(cut.solid);
  ASSERT_EQ(cut.section.regions.size(), 1U);
  EXPECT_NEAR(cut.removed_mm3, 50.0 - 0.2, 1e-10);
  EXPECT_EQ(split_pieces(cut.solid).size(), 2U);
}

TEST(Cut, ABoneThatOverlapsItselfStillClosesAndBalances) {
  IndexedMesh mesh = solid_block(Vec3(20.0, 8.0, 6.0));
  append_mesh(mesh, moved(solid_block(Vec3(9.0, 7.0, 12.0)),
                          {rotation_about(Vec3(1.0, 0.0, 0.0), 0.4), Vec3(4.0, 2.0, 1.0)}));
  const CutSolid solid = uncut_solid(mesh);
  for (const double offset_mm : {-0.3, 1.0, 3.9, 4.6}) {
    const CutOutcome cut =
        cut_through(solid, plane_through(Vec3(offset_mm, 0.2, 0.1), Vec3(0.5, 0.3, 0.8), 0.7));
    expect_closed(cut.solid);
    expect_balance(solid, cut);
  }
}

TEST(Cut, WallsStandHalfAKerfFromThePlane) {
  const CutSolid solid = uncut_solid(sphere(9.0, 12));
  const KerfPlane plane = plane_through(Vec3(1.0, 0.5, -0.3), Vec3(0.3, 0.5, 0.7), 0.6);
  const CutOutcome cut = cut_through(solid, plane, 2);
  const KerfAxes axes = axes_of(plane);
  std::size_t walls = 0;
  for (std::size_t i = 0; i < cut.solid.mesh.triangles.size(); ++i) {
    const FaceSource& source = cut.solid.sources[i];
    for (const std::uint32_t corner : cut.solid.mesh.triangles[i]) {
      const double z_mm = height_mm(axes, cut.solid.mesh.points_mm[corner]);
      EXPECT_GE(std::abs(z_mm), 0.3 - 1e-9);
      if (source.kerf == 2) {
        EXPECT_NEAR(z_mm, 0.3 * source.side, 1e-9);
      }
    }
    if (source.kerf == 2) ++walls;
  }
  EXPECT_GT(walls, 0U);
}

TEST(Cut, TwoArmsOfAChevronFreeAWedge) {
  const CutSolid solid = block();
  const CutOutcome first =
      cut_through(solid, plane_through(Vec3(0.0), Vec3(1.0, 0.4, 0.0), 0.5), 0);
  const CutOutcome second =
      cut_through(first.solid, plane_through(Vec3(0.0), Vec3(1.0, -0.4, 0.0), 0.5), 1);
  expect_closed(first.solid);
  expect_closed(second.solid);
  expect_balance(solid, first);
  expect_balance(first.solid, second);
  EXPECT_EQ(split_pieces(second.solid).size(), 4U);
}

TEST(Cut, TheSamePlaneAgainFindsOnlyItsOwnWalls) {
  const KerfPlane plane = plane_through(Vec3(0.4, 0.0, 0.0), Vec3(0.9, 0.2, 0.1), 0.5);
  const CutOutcome first = cut_through(block(), plane, 0);
  const CutOutcome again = cut_through(first.solid, plane, 1);
  expect_closed(again.solid);
  EXPECT_NEAR(again.removed_mm3, 0.0, 1e-9);
  EXPECT_NEAR(signed_volume_mm3(again.solid.mesh), signed_volume_mm3(first.solid.mesh), 1e-8);
}

TEST(Cut, AParallelKerfBesideTheFirstCloses) {
  CutSolid solid = block();
  for (std::int32_t i = 0; i < 4; ++i) {
    const CutOutcome cut = cut_through(solid, axis_plane(0, 0.5 * i, 0.5), i);
    expect_closed(cut.solid);
    expect_balance(solid, cut);
    EXPECT_NEAR(cut.removed_mm3, 84.0, 1e-9);
    solid = cut.solid;
  }
}

TEST(Cut, AMirroredBoneGivesTheMirroredCut) {
  IndexedMesh mirrored = hollow_tube({.rings = 5});
  for (Vec3& point_mm : mirrored.points_mm) point_mm.y = -point_mm.y;
  mirrored = inside_out(mirrored);
  const Vec3 normal(0.9, 0.3, 0.2);
  const CutSolid solid = uncut_solid(hollow_tube({.rings = 5}));
  const CutOutcome plain = cut_through(solid, plane_through(Vec3(0.3), normal, 0.5));
  const CutOutcome other = cut_through(
      uncut_solid(mirrored), plane_through(Vec3(0.3, -0.3, 0.3), Vec3(0.9, -0.3, 0.2), 0.5));
  expect_closed(other.solid);
  EXPECT_NEAR(other.removed_mm3, plain.removed_mm3, 1e-10 * plain.removed_mm3);
  for (const CutSolid& piece : split_pieces(other.solid)) {
    EXPECT_GT(signed_volume_mm3(piece.mesh), 0.0);
  }
}

}  // namespace
}  // namespace hallux::tests
