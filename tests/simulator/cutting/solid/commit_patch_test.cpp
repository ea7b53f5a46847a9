#include "simulator/cutting/solid/commit_patch.h"

#include <gtest/gtest.h>

#include <cmath>

#include "simulator/cutting/solid/mend_solid.h"
#include "simulator/cutting/solid/opened_volume.h"
#include "simulator/mesh/read_mesh.h"
#include "tests/simulator/cutting/worlds/cut_through.h"
#include "tests/simulator/cutting/worlds/outlines.h"
#include "tests/simulator/cutting/worlds/shown_solid.h"
#include "tests/support/worlds.h"

namespace hallux::tests {
namespace {

using namespace simulator;

const FieldGrid grid{.origin_mm = Vec2(-40.0), .spacing_mm = 1.0, .u_count = 81, .v_count = 81};

KerfCut cut(const CutSolid& solid, const KerfPlane& plane, const RegionOutline& region,
            std::int32_t kerf = 0) {
  return cut_kerf(solid, Bvh(solid.mesh), plane, kerf, grid, region);
}

std::array<Vec3, 3> places(const CutSolid& solid, std::size_t triangle) {
  const Triangle& corners = solid.mesh.triangles[triangle];
  return {solid.mesh.points_mm[corners[0]], solid.mesh.points_mm[corners[1]],
          solid.mesh.points_mm[corners[2]]};
}

TEST(CommitPatch, TrianglesThatWereNotHiddenKeepTheirOrderAndTheirBits) {
  const CutSolid solid = uncut_solid(hollow_tube({.segments = 24, .rings = 8}));
  const KerfPlane plane = plane_through(Vec3(1.0, 0.0, 0.0), Vec3(1.0, 0.3, 0.1), 0.5);
  const SlabSlice contact = slice_slab(solid, Bvh(solid.mesh), plane, 0, Vec2(-40.0), Vec2(40.0));
  PatchBuilder builder(contact);
  SolidPatch patch;
  ASSERT_TRUE(builder.build(outline_from({diamond_loop(Vec2(3.0, 1.0), 6.0)}), patch));
  const CutSolid committed = commit_patch(solid, patch);
  EXPECT_TRUE(is_strictly_closed(committed.mesh));
  std::size_t at = 0, next_hidden = 0;
  for (std::uint32_t i = 0; i < solid.mesh.triangles.size(); ++i) {
    if (next_hidden < patch.hidden.size() && patch.hidden[next_hidden] == i) {
      ++next_hidden;
      continue;
    }
    ASSERT_EQ(places(committed, at), places(solid, i));
    ASSERT_EQ(committed.sources[at], solid.sources[i]);
    ++at;
  }
  EXPECT_EQ(next_hidden, patch.hidden.size());
  EXPECT_NO_THROW(check_closed_solid(committed.mesh, "committed"));
}

TEST(CutKerf, SaysWhatItTookAndWhetherTheSectionIsGone) {
  const CutSolid block = uncut_solid(solid_block(Vec3(20.0, 10.0, 8.0)));
  const KerfPlane plane = axis_plane(0, 1.0, 0.5);
  const KerfCut half = cut(block, plane, rectangle_outline(Vec2(-9.0), Vec2(0.0, 9.0)));
  EXPECT_NEAR(half.removed_mm3, 5.0 * 8.0 * 0.5, 1e-12 * 20.0);
  EXPECT_FALSE(half.takes_section);
  EXPECT_EQ(half.nudges, 0U);
  EXPECT_EQ(split_pieces(half.solid).size(), 1U);
  const KerfCut whole = cut(block, plane, whole_plane());
  EXPECT_NEAR(whole.removed_mm3, 40.0, 1e-12 * 40.0);
  EXPECT_TRUE(whole.takes_section);
  EXPECT_EQ(split_pieces(whole.solid).size(), 2U);
}

TEST(CutKerf, WhatReachesNothingLeavesTheSolidAsItIs) {
  const CutSolid block = uncut_solid(solid_block(Vec3(20.0, 10.0, 8.0)));
  const KerfCut missed = cut(block, axis_plane(0, 11.0, 0.5), whole_plane());
  EXPECT_EQ(missed.solid.mesh.points_mm, block.mesh.points_mm);
  EXPECT_EQ(missed.solid.mesh.triangles, block.mesh.triangles);
  EXPECT_EQ(missed.removed_mm3, 0.0);
  EXPECT_FALSE(missed.takes_section);
}

TEST(CutKerf, ARegionThatStaysRefusedLeavesTheSolidAsItIs) {
  const CutSolid block = uncut_solid(solid_block(Vec3(20.0, 10.0, 8.0)));
  const LoopCorners square = rectangle_loop(Vec2(-9.0), Vec2(9.0));
  const KerfCut refused = cut(block, axis_plane(0, 1.0, 0.5), outline_from({square, square}));
  EXPECT_GT(refused.nudges, 1U);
  EXPECT_EQ(refused.removed_mm3, 0.0);
  EXPECT_EQ(refused.solid.mesh.triangles, block.mesh.triangles);
}

// The second kerf comes at 20 degrees to the first and meets it below the block's underside: a
// wedge falls off.
TEST(CutKerf, TwoKerfsThatMeetSetAWedgeFree) {
  const CutSolid block = uncut_solid(solid_block(Vec3(20.0, 10.0, 8.0)));
  const KerfCut first = cut(block, axis_plane(0, -1.0, 0.5), whole_plane(), 0);
  const double tangent = 0.25, length = std::sqrt(1.0 + tangent * tangent);
  const KerfPlane slanted = plane_through(Vec3(1.0, 0.0, 0.0), Vec3(1.0, 0.0, tangent) / length,
                                          0.5, Vec3(0.0, 1.0, 0.0));
  const KerfCut second = cut(first.solid, slanted, whole_plane(), 1);
  EXPECT_TRUE(is_strictly_closed(second.solid.mesh));
  EXPECT_EQ(second.nudges, 0U);
  // Between x = -0.75 and the slanted kerf's near plane x = 1 - 0.25 length - 0.25 z.
  std::vector<double> volumes_mm3;
  for (const CutSolid& piece : split_pieces(second.solid)) {
    volumes_mm3.push_back(signed_volume_mm3(piece.mesh));
  }
  ASSERT_EQ(volumes_mm3.size(), 3U);
  const double left_mm3 = (-1.25 + 10.0) * 80.0;
  const double wedge_mm3 = (1.75 - 0.25 * length) * 80.0;
  const double right_mm3 = (10.0 - 1.0 - 0.25 * length) * 80.0;
  EXPECT_NEAR(volumes_mm3[0], left_mm3, 1e-4);
  EXPECT_NEAR(volumes_mm3[1], right_mm3, 1e-4);
  EXPECT_NEAR(volumes_mm3[2], wedge_mm3, 1e-4);
  EXPECT_NEAR(first.removed_mm3 + second.removed_mm3 + left_mm3 + wedge_mm3 + right_mm3, 1600.0,
              1e-9);
}

TEST(CutKerf, TheSameKerfAgainTakesNothingAndAddsNothingToThePieces) {
  const CutSolid tube = uncut_solid(hollow_tube({.segments = 24, .rings = 4}));
  const KerfPlane plane = plane_through(Vec3(1.0, 0.0, 0.0), Vec3(1.0, 0.3, 0.1), 0.5);
  for (const RegionOutline& region :
       {whole_plane(), rectangle_outline(Vec2(-20.0, -20.0), Vec2(20.0, 1.3))}) {
    const KerfCut once = cut(tube, plane, region, 0);
    const KerfCut twice = cut(once.solid, plane, region, 0);
    EXPECT_TRUE(is_strictly_closed(twice.solid.mesh));
    EXPECT_NEAR(twice.removed_mm3, 0.0, 1e-6);
    EXPECT_NEAR(signed_volume_mm3(twice.solid.mesh), signed_volume_mm3(once.solid.mesh), 1e-6);
    EXPECT_EQ(body_count(twice.solid.mesh), body_count(once.solid.mesh));
    EXPECT_LE(twice.solid.mesh.triangles.size(), 2 * once.solid.mesh.triangles.size());
  }
}

TEST(MendSolid, EdgesNamedTwiceGetPointsOfTheirOwn) {
  // Two tetrahedra that share an edge: four triangles use it.
  CutSolid solid;
  solid.mesh.points_mm = {Vec3(0.0),           Vec3(0.0, 0.0, 1.0),  Vec3(1.0, 0.0, 0.0),
                          Vec3(1.0, 1.0, 0.0), Vec3(-1.0, 0.0, 0.0), Vec3(-1.0, -1.0, 0.0),
                          Vec3(99.0, 0.0, 0.0)};
  solid.mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3},
                          {0, 4, 1}, {0, 1, 5}, {0, 5, 4}, {1, 4, 5}};
  solid.sources.assign(8, {2, 1});
  const double volume_mm3 = signed_volume_mm3(solid.mesh);
  ASSERT_TRUE(is_closed_as_chain(solid.mesh));
  ASSERT_FALSE(is_strictly_closed(solid.mesh));
  separate_repeated_edges(solid, 0);
  drop_unused_points(solid.mesh);
  EXPECT_TRUE(is_strictly_closed(solid.mesh));
  EXPECT_EQ(solid.mesh.points_mm.size(), 7U);
  EXPECT_EQ(solid.sources.size(), solid.mesh.triangles.size());
  EXPECT_NEAR(signed_volume_mm3(solid.mesh), volume_mm3, 1e-15);
}

}  // namespace
}  // namespace hallux::tests
