#include "simulator/bone/cut_bone.h"

#include <gtest/gtest.h>

#include <utility>

#include "tests/support/worlds.h"

namespace hallux::simulator {
namespace {

constexpr double kerf_mm = 0.5;
/// A block of 20 x 4 x 6 mm about the origin: a kerf across x takes 12 mm3.
constexpr double section_mm2 = 4.0 * 6.0;
constexpr double block_mm3 = 20.0 * section_mm2;

IndexedMesh block() { return tests::solid_block({20.0, 4.0, 6.0}); }

/// Across x; open over y from -3 to `to_y_mm`, and over all of z.
OpenedKerf across(std::int32_t number, double x_mm, double to_y_mm) {
  OpenedKerf kerf;
  kerf.number = number;
  kerf.plane = {
      {rotation_from_axes(Vec3(0.0, 1.0, 0.0), Vec3(0.0, 0.0, 1.0)), Vec3(x_mm, 0.0, 0.0)},
      kerf_mm};
  kerf.grid = {.origin_mm = {-10.0, -10.0}, .u_count = 401, .v_count = 401};
  kerf.region = {{{-3.0, -4.0}, {to_y_mm, -4.0}, {to_y_mm, 4.0}, {-3.0, 4.0}}, {4}};
  return kerf;
}
OpenedKerf unopened(std::int32_t number, double x_mm) {
  OpenedKerf kerf = across(number, x_mm, 0.0);
  kerf.region = {};
  return kerf;
}

TEST(CutBone, WithoutKerfsIsWhole) {
  CutBone bone(block());
  EXPECT_EQ(bone.after_all().mesh, block());
  EXPECT_EQ(bone.pieces().gathered().mesh, block());
}

TEST(CutBone, AKerfThatOpenedNothingTakesNothing) {
  CutBone bone(block());
  bone.put_kerf(0, unopened(0, 2.0));
  EXPECT_EQ(bone.cut(0).removed_mm3, 0.0);
  EXPECT_FALSE(bone.cut(0).takes_section);
  EXPECT_EQ(bone.after_all().mesh, block());
}

TEST(CutBone, EachKerfCutsWhatTheKerfsBeforeItLeave) {
  CutBone bone(block());
  bone.put_kerf(0, across(0, 2.0, 3.0));
  bone.put_kerf(1, across(1, 2.25, 3.0));
  EXPECT_NEAR(bone.cut(0).removed_mm3, kerf_mm * section_mm2, 1.0e-6);
  EXPECT_NEAR(bone.cut(1).removed_mm3, 0.5 * kerf_mm * section_mm2, 1.0e-6)
      << "half of its slab is gone already";
  EXPECT_TRUE(bone.cut(0).takes_section);
}

TEST(CutBone, OpenedFurtherIsAsIfItHadBeenOpenedSoAtOnce) {
  CutBone slow(block()), quick(block());
  slow.put_kerf(0, across(0, 2.0, 1.0));
  slow.put_kerf(1, across(1, -2.0, 3.0));
  EXPECT_NEAR(slow.cut(0).removed_mm3, 0.75 * kerf_mm * section_mm2, 1.0e-6);
  slow.after_all();
  slow.put_kerf(0, across(0, 2.0, 3.0));
  quick.put_kerf(0, across(0, 2.0, 3.0));
  quick.put_kerf(1, across(1, -2.0, 3.0));
  EXPECT_EQ(slow.after_all().mesh, quick.after_all().mesh);
}

TEST(CutBone, AnEarlyKerfMayGoOnAfterSeveralOthers) {
  CutBone slow(block()), quick(block());
  for (const auto& [number, x_mm] : {std::pair{0, 6.0}, {1, 2.0}, {2, -2.0}, {3, -6.0}}) {
    slow.put_kerf(number, across(number, x_mm, 1.0));
    slow.cut(number);
  }
  for (const auto& [number, x_mm] : {std::pair{2, -2.0}, {0, 6.0}, {3, -6.0}, {1, 2.0}}) {
    slow.put_kerf(number, across(number, x_mm, 3.0));
    for (std::int32_t place = 0; place < slow.kerf_count(); ++place) slow.cut(place);
    slow.before(number);
  }
  for (const auto& [number, x_mm] : {std::pair{0, 6.0}, {1, 2.0}, {2, -2.0}, {3, -6.0}}) {
    quick.put_kerf(number, across(number, x_mm, 3.0));
  }
  EXPECT_EQ(slow.after_all().mesh, quick.after_all().mesh);
  EXPECT_EQ(slow.after_all().sources, quick.after_all().sources);
}

TEST(CutBone, MayBeOpenedLessThanBefore) {
  CutBone bone(block());
  bone.put_kerf(0, across(0, 2.0, 3.0));
  bone.after_all();
  bone.put_kerf(0, unopened(0, 2.0));
  EXPECT_EQ(bone.after_all().mesh, block());
}

TEST(CutBone, AllButOneIsTheBoneWhoseOtherKerfsWereCut) {
  CutBone bone(block()), other(block());
  bone.put_kerf(0, across(0, 2.0, 3.0));
  bone.put_kerf(1, across(1, -2.0, 3.0));
  other.put_kerf(0, across(1, -2.0, 3.0));
  EXPECT_EQ(bone.all_but(0).mesh, other.after_all().mesh);
  EXPECT_EQ(bone.all_but(0).sources, other.after_all().sources);
  EXPECT_EQ(bone.all_but(1).mesh, bone.before(1).solid.mesh);
  EXPECT_EQ(bone.all_but(-1).mesh, bone.after_all().mesh);
}

TEST(CutBone, ThatIsBorrowedIsCutLikeItsOwn) {
  const WholeBone whole(block());
  CutBone borrowed(whole), own(block());
  EXPECT_EQ(&borrowed.before(0).bvh, &whole.tree) << "nothing is built again";
  EXPECT_EQ(&borrowed.whole(), &whole.solid);
  for (CutBone* const bone : {&borrowed, &own}) {
    bone->put_kerf(0, across(0, 2.0, 3.0));
    bone->put_kerf(1, across(1, -2.0, 3.0));
    bone->number_pieces();
  }
  EXPECT_EQ(borrowed.after_all().mesh, own.after_all().mesh);
  EXPECT_EQ(borrowed.all_but(0).mesh, own.all_but(0).mesh);
  EXPECT_EQ(borrowed.pieces().pieces().size(), 3U);
  EXPECT_EQ(borrowed.pieces().gathered().mesh, own.pieces().gathered().mesh);
  EXPECT_EQ(whole.solid.mesh, block());
}

TEST(CutBone, AKerfMovedLastIsCutFromWhatTheOthersLeave) {
  CutBone bone(block());
  bone.put_kerf(0, across(7, 2.0, 3.0));
  bone.put_kerf(1, across(8, 2.25, 3.0));
  bone.after_all();
  bone.move_last(0);
  EXPECT_EQ(bone.kerf(0).number, 8);
  EXPECT_EQ(bone.kerf(1).number, 7);
  EXPECT_NEAR(bone.cut(0).removed_mm3, kerf_mm * section_mm2, 1.0e-6);
  EXPECT_NEAR(bone.cut(1).removed_mm3, 0.5 * kerf_mm * section_mm2, 1.0e-6);
}

TEST(CutBone, ItsPiecesKeepTheirNumbersWhileAKerfGoesOn) {
  CutBone bone(block());
  bone.put_kerf(0, across(0, 6.0, 3.0));
  bone.number_pieces();
  ASSERT_EQ(bone.pieces().pieces().size(), 2U);
  bone.put_kerf(1, across(1, -5.0, 3.0));
  bone.number_pieces();
  ASSERT_EQ(bone.pieces().pieces().size(), 3U);
  EXPECT_EQ(bone.pieces().pieces()[0].id, 0);
  EXPECT_EQ(bone.pieces().pieces()[1].id, 2);
  EXPECT_TRUE(bone.pieces().pieces()[1].is_new);
  EXPECT_EQ(bone.pieces().pieces()[2].id, 1);
  EXPECT_FALSE(bone.pieces().pieces()[2].is_new);
}

TEST(CutBone, WhatWasTakenOutCountsAmongWhatTheKerfsLeaveAndNotAmongThePieces) {
  CutBone bone(block());
  bone.put_kerf(0, across(0, 5.0, 3.0));
  bone.number_pieces();
  ASSERT_NE(bone.take_out(1), nullptr);
  EXPECT_NEAR(signed_volume_mm3(bone.after_all().mesh), block_mm3 - kerf_mm * section_mm2, 1.0e-6);
  bone.number_pieces();
  ASSERT_EQ(bone.pieces().pieces().size(), 1U);
  EXPECT_NEAR(bone.pieces().pieces()[0].volume_mm3, (15.0 - 0.5 * kerf_mm) * section_mm2, 1.0e-6);
}

}  // namespace
}  // namespace hallux::simulator
