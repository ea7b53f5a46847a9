#include "simulator/bone/numbered_pieces.h"

#include <gtest/gtest.h>

#include "tests/support/worlds.h"

namespace hallux::simulator {
namespace {

/// Numbers what is left, from 1 on or from where the last call ended.
struct Numbering {
  std::int32_t next = 1;
  void operator()(NumberedPieces& pieces, std::vector<CutSolid> solids) {
    pieces.number(std::move(solids), next);
  }
};

/// A block from x = `from_mm` to `to_mm`, 4 x 6 mm across.
CutSolid block(double from_mm, double to_mm) {
  IndexedMesh mesh = tests::solid_block({to_mm - from_mm, 4.0, 6.0});
  for (Vec3& point : mesh.points_mm) point.x += 0.5 * (from_mm + to_mm);
  return uncut_solid(std::move(mesh));
}

/// A block of 20 mm cut into 13, 3 and 3 mm: two pieces of equal volume beside the bone.
std::vector<CutSolid> bone_and_twins() {
  return {block(-6.5, 6.5), block(-10.0, -7.0), block(7.0, 10.0)};
}

TEST(NumberedPieces, TwoOfEqualVolumeAreKnownByWhereTheyLie) {
  Numbering number;
  NumberedPieces pieces(block(-10.0, 10.0));
  number(pieces, bone_and_twins());
  ASSERT_EQ(pieces.pieces().size(), 3U);
  EXPECT_EQ(pieces.pieces()[1].id, 1);
  EXPECT_EQ(pieces.pieces()[2].id, 2);
  EXPECT_EQ(pieces.pieces()[1].volume_mm3, pieces.pieces()[2].volume_mm3);
  const Bvh* const body = pieces.take_out(2);
  ASSERT_NE(body, nullptr);
  EXPECT_TRUE(body->contains({8.0, 0.0, 0.0}));
  number(pieces, bone_and_twins());
  ASSERT_EQ(pieces.pieces().size(), 2U);
  EXPECT_EQ(pieces.pieces()[1].id, 1);
  EXPECT_LT(pieces.pieces()[1].solid.mesh.points_mm.front().x, 0.0);
}

TEST(NumberedPieces, OfSeveralPartsTheLargestKeepsTheNumber) {
  Numbering number;
  NumberedPieces pieces(block(-10.0, 10.0));
  number(pieces, {block(-10.0, 2.0), block(3.0, 10.0)});
  number(pieces, {block(-10.0, 2.0), block(5.0, 10.0), block(3.0, 4.0)});
  ASSERT_EQ(pieces.pieces().size(), 3U);
  EXPECT_EQ(pieces.pieces()[1].id, 1);
  EXPECT_FALSE(pieces.pieces()[1].is_new);
  EXPECT_EQ(pieces.pieces()[2].id, 2);
  EXPECT_TRUE(pieces.pieces()[2].is_new);
}

TEST(NumberedPieces, CrumbsAreDebrisAndHaveNoNumber) {
  Numbering number;
  NumberedPieces pieces(block(-10.0, 10.0));
  number(pieces, {block(-10.0, 9.0), block(9.5, 9.501)});
  EXPECT_EQ(pieces.pieces().size(), 1U);
  EXPECT_NEAR(pieces.debris_mm3(), 0.024, 1.0e-9);
  EXPECT_EQ(pieces.gathered().mesh.triangles.size(), 24U);
}

TEST(NumberedPieces, ANumberThatNoPieceHasTakesNothingOut) {
  Numbering number;
  NumberedPieces pieces(block(-10.0, 10.0));
  number(pieces, bone_and_twins());
  EXPECT_EQ(pieces.take_out(5), nullptr);
  EXPECT_EQ(pieces.pieces().size(), 3U);
}

TEST(NumberedPieces, NothingIsLeftOutOfABoneOnWhichATakenPieceWouldHangAgain) {
  Numbering number;
  NumberedPieces pieces(block(-10.0, 10.0));
  number(pieces, bone_and_twins());
  pieces.take_out(2);
  CutSolid cut;
  for (const CutSolid& solid : bone_and_twins()) append_solid(cut, solid);
  const std::optional<CutSolid> left = pieces.without_taken_out(cut);
  ASSERT_TRUE(left.has_value());
  EXPECT_NEAR(signed_volume_mm3(left->mesh), 16.0 * 24.0, 1.0e-9);
  EXPECT_FALSE(pieces.without_taken_out(block(-10.0, 10.0)).has_value());
}

}  // namespace
}  // namespace hallux::simulator
