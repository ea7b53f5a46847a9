#include "simulator/cutting/pieces/cut_solid.h"

#include <gtest/gtest.h>

#include "tests/support/worlds.h"

namespace hallux::tests {
namespace {

using namespace simulator;

TEST(SplitPieces, TheLargestComesFirst) {
  IndexedMesh mesh = solid_block(Vec3(2.0));
  append_mesh(mesh, moved(solid_block(Vec3(5.0)), {Quat(1, 0, 0, 0), Vec3(20.0, 0.0, 0.0)}));
  const std::vector<CutSolid> pieces = split_pieces(uncut_solid(mesh));
  ASSERT_EQ(pieces.size(), 2U);
  EXPECT_NEAR(signed_volume_mm3(pieces[0].mesh), 125.0, 1e-9);
  EXPECT_NEAR(signed_volume_mm3(pieces[1].mesh), 8.0, 1e-9);
}

TEST(SplitPieces, EqualPiecesKeepTheOrderOfTheirPoints) {
  const std::vector<CutSolid> pieces = split_pieces(uncut_solid(two_blocks(Vec3(4.0), 2.0)));
  ASSERT_EQ(pieces.size(), 2U);
  const IndexedMesh whole = two_blocks(Vec3(4.0), 2.0);
  EXPECT_EQ(pieces[0].mesh.points_mm.front(), whole.points_mm.front());
}

TEST(SplitPieces, ACanalGoesWithTheBoneAroundIt) {
  IndexedMesh mesh = solid_block(Vec3(40.0, 40.0, 40.0));
  append_mesh(mesh, inside_out(solid_block(Vec3(30.0))));
  append_mesh(mesh, solid_block(Vec3(20.0)));  // an island in the void, with a void of its own
  append_mesh(mesh, inside_out(solid_block(Vec3(10.0))));
  const std::vector<CutSolid> pieces = split_pieces(uncut_solid(mesh));
  ASSERT_EQ(pieces.size(), 2U);
  EXPECT_NEAR(signed_volume_mm3(pieces[0].mesh), 64000.0 - 27000.0, 1e-7);
  EXPECT_NEAR(signed_volume_mm3(pieces[1].mesh), 8000.0 - 1000.0, 1e-7);
  EXPECT_EQ(pieces[0].sources.size(), pieces[0].mesh.triangles.size());
}

}  // namespace
}  // namespace hallux::tests
