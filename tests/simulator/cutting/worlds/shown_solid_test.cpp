/// The judges are judged: each must find the fault that it is there for.
#include "tests/simulator/cutting/worlds/shown_solid.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/simulator/cutting/frames/frame_count.h"
#include "tests/support/worlds.h"

namespace hallux::tests {
namespace {

using namespace simulator;

TEST(ShownSolid, AMissingOrTurnedTriangleIsNotClosed) {
  const IndexedMesh block = solid_block(Vec3(2.0));
  EXPECT_TRUE(is_closed_as_chain(block));
  EXPECT_TRUE(is_strictly_closed(block));
  IndexedMesh open = block, turned = block;
  open.triangles.pop_back();
  std::swap(turned.triangles[0][0], turned.triangles[0][1]);
  for (const IndexedMesh& mesh : {open, turned}) {
    EXPECT_FALSE(is_closed_as_chain(mesh));
    EXPECT_FALSE(is_strictly_closed(mesh));
  }
}

TEST(ShownSolid, RepeatedEdgesUnusedPointsAndNoNumbersAreNotStrict) {
  const IndexedMesh block = solid_block(Vec3(2.0));
  IndexedMesh doubled = block, loose = block, no_number = block, twice = block;
  doubled.triangles.insert(doubled.triangles.end(), block.triangles.begin(), block.triangles.end());
  loose.points_mm.emplace_back(0.0);
  no_number.points_mm[0].x = std::numeric_limits<double>::quiet_NaN();
  twice.triangles.push_back({0, 0, 1});
  twice.triangles.push_back({0, 1, 0});
  for (const IndexedMesh& mesh : {doubled, loose, no_number, twice}) {
    EXPECT_FALSE(is_strictly_closed(mesh));
  }
  EXPECT_TRUE(is_closed_as_chain(doubled));
}

TEST(ShownSolid, ACanalIsNoBodyAndDebrisIsNone) {
  EXPECT_EQ(body_count(hollow_tube({})), 1U);
  EXPECT_EQ(body_count(two_blocks(Vec3(2.0), 1.0)), 2U);
  EXPECT_EQ(body_count(two_blocks(Vec3(0.2), 1.0)), 0U);
  EXPECT_EQ(shell_volumes_mm3(hollow_tube({})).size(), 2U);
}

TEST(ShownSolid, HiddenTrianglesGoAndPatchTrianglesCome) {
  const CutSolid block = uncut_solid(solid_block(Vec3(2.0)));
  SolidPatch patch;
  patch.hidden = {3, 7};
  patch.points_in_bone_mm = {Vec3(5.0)};
  patch.triangles = {{0, 1, 8}};
  const IndexedMesh shown = shown_mesh(block, patch);
  EXPECT_EQ(shown.points_mm.size(), 9U);
  ASSERT_EQ(shown.triangles.size(), 11U);
  EXPECT_EQ(shown.triangles[3], block.mesh.triangles[4]);
  EXPECT_EQ(shown.triangles.back(), (Triangle{0, 1, 8}));
}

TEST(FrameCount, SharesOfTenPercentOrLessAndEveryFaultAreComplaints) {
  FrameCount count;
  count.frames = 100;
  count.intersected = 90;
  count.partial = 50;
  count.severed = count.nested = 11;
  EXPECT_TRUE(complaints(count).empty());
  count.severed = 10;
  EXPECT_EQ(complaints(count).size(), 1U);
  count.faults.emplace_back("open: world 1, kerf 0, frame 0");
  EXPECT_EQ(complaints(count).size(), 2U);
  EXPECT_EQ(complaints({}).size(), 4U);
}

}  // namespace
}  // namespace hallux::tests
