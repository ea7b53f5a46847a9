/// A bar that is sawn in two, its halves moved or taken out and sawn again: rebuilt from what was
/// recorded.
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "assessment/rebuild/rebuild.h"
#include "tests/simulator/step/simulation_run.h"
#include "tests/support/worlds.h"

namespace hallux::assessment {
namespace {

using simulator::CommandKind;
using tests::blade_down;

constexpr double cut_x_mm = 5.0;
constexpr double bar_mm3 = 30.0 * 8.0 * 8.0;

class HalvedBar : public testing::Test {
 protected:
  HalvedBar() { saw(cut_x_mm); }

  void saw(double x_mm, double z_mm = 0.0, double lean_rad = 0.0) {
    run_.glide(blade_down({x_mm, 12.0, z_mm}, lean_rad), 300);
    run_.glide(blade_down({x_mm, -9.0, z_mm}, lean_rad), 2000);
    run_.hold(1500);
    run_.glide(blade_down({x_mm, 30.0, z_mm}, lean_rad), 400);
    run_.hold(20);
  }
  RebuiltBone rebuilt() const { return rebuild(bone_, {}, run_.recording()); }

  simulator::Bone bone_ = tests::cancellous_bone(tests::solid_block({30.0, 8.0, 8.0}));
  tests::SimulationRun run_{bone_, blade_down({cut_x_mm, 12.0, 0.0})};
};

class MovedHalf : public HalvedBar {
 protected:
  MovedHalf() {
    run_.step({{CommandKind::Grip, simulator::piece_freed_last, 0}});
    run_.hold(3);
    run_.glide(blade_down({cut_x_mm, 30.0, 4.0}), 400);
    run_.step({{CommandKind::Release, 0, 0}});
    run_.hold(2);
  }
};

double sum_of(const RebuiltBone& rebuilt) {
  return std::accumulate(rebuilt.piece_volumes_mm3.begin(), rebuilt.piece_volumes_mm3.end(),
                         rebuilt.removed_mm3 + rebuilt.debris_mm3);
}

TEST_F(MovedHalf, IsAFragmentOfItsOwn) {
  const RebuiltBone bone = rebuilt();
  ASSERT_EQ(bone.fragments.size(), 2U);
  EXPECT_EQ(bone.fragments[0].piece, 0);
  EXPECT_EQ(bone.fragments[1].piece, 1);
  EXPECT_EQ(bone.fragments[1].piece_count, 1U);
  EXPECT_NEAR(bone.piece_volumes_mm3.at(1), 9.75 * 64.0, 0.1);
  const RigidTransform& pose = bone.fields.fragments()[1].bone_from_fragment;
  EXPECT_NEAR(pose.translation_mm.z, 4.0, 0.01);
  EXPECT_NEAR(bone.input_mm3(), bar_mm3, 1e-9);
  EXPECT_NEAR(sum_of(bone), bone.input_mm3(), 1e-6 * bone.input_mm3());
}

TEST_F(MovedHalf, IsSawnInItsOwnFrame) {
  saw(10.0, 4.0);
  const RebuiltBone bone = rebuilt();
  ASSERT_EQ(bone.kerfs.size(), 2U);
  EXPECT_EQ(bone.fields.fragment_of(1), 1);
  EXPECT_TRUE(bone.kerfs[1].is_finished());
  ASSERT_EQ(bone.fragments.size(), 2U);
  EXPECT_EQ(bone.fragments[0].piece_count, 1U) << "what lies under the blade's way was not there";
  EXPECT_EQ(bone.fragments[1].piece_count, 2U);
  EXPECT_NEAR(sum_of(bone), bone.input_mm3(), 1e-6 * bone.input_mm3());
}

TEST_F(MovedHalf, LeavesABoneThatIsSawnOn) {
  saw(-5.0);
  const RebuiltBone bone = rebuilt();
  ASSERT_EQ(bone.kerfs.size(), 2U);
  EXPECT_EQ(bone.fields.fragment_of(1), 0);
  EXPECT_EQ(bone.fragments[0].piece_count, 2U);
  EXPECT_EQ(bone.fragments[1].piece_count, 1U);
  EXPECT_NEAR(sum_of(bone), bone.input_mm3(), 1e-6 * bone.input_mm3());
}

TEST_F(MovedHalf, IsTheSameFromKeptFields) {
  saw(10.0, 4.0);
  const OpenedFields opened = opened_fields({}, bone_, run_.recording());
  const RebuiltBone kept = rebuild(bone_, {}, run_.recording(), {}, &opened);
  const RebuiltBone fresh = rebuilt();
  EXPECT_EQ(kept.piece_volumes_mm3, fresh.piece_volumes_mm3);
  EXPECT_EQ(kept.removed_mm3, fresh.removed_mm3);
}

TEST_F(MovedHalf, HasThePiecesOfTheAttempt) {
  saw(10.0, 4.0);
  const RebuiltBone bone = rebuilt();
  for (std::int32_t fragment = 0; fragment < 2; ++fragment) {
    const auto& pieces = run_.jobs().geometry().pieces(fragment);
    const RebuiltFragment& own = bone.fragments[static_cast<std::size_t>(fragment)];
    ASSERT_EQ(pieces.size(), own.piece_count);
    for (std::size_t i = 0; i < pieces.size(); ++i)
      EXPECT_NEAR(bone.piece_volumes_mm3[own.first_piece + i], pieces[i].volume_mm3, 1e-9);
  }
}

TEST_F(MovedHalf, ThatWasTakenOutIsStillCounted) {
  run_.step({{CommandKind::PickUp, 1, 0}});
  const RebuiltBone bone = rebuilt();
  EXPECT_TRUE(bone.fragments.at(1).is_out);
  EXPECT_FALSE(bone.fragments.at(0).is_out);
  EXPECT_NEAR(sum_of(bone), bone.input_mm3(), 1e-6 * bone.input_mm3());
}

/// Of what was taken out, each.
std::vector<double> volumes_out(const RebuiltBone& rebuilt) {
  std::vector<double> volumes_mm3;
  for (std::size_t piece = 0; piece < rebuilt.pieces.size(); ++piece)
    if (rebuilt.is_piece_out[piece]) volumes_mm3.push_back(rebuilt.piece_volumes_mm3[piece]);
  return volumes_mm3;
}

/// The kerf at 5 mm took 0.25 mm to either side.
constexpr double half_begins_mm = 5.25, rest_ends_mm = 4.75;
constexpr double half_mm3 = (15.0 - half_begins_mm) * 64.0;

/// A leaning kerf comes out of the rest's sawn face, and would go on into what lay beyond.
TEST_F(HalvedBar, HasNoBoneForALaterKerfWhereAPieceWasTakenOut) {
  run_.step({{CommandKind::PickUp, simulator::piece_freed_last, 0}});
  constexpr double lean_rad = 0.4, x_mm = 4.0;
  saw(x_mm, 0.0, lean_rad);
  const RebuiltBone bone = rebuilt();
  ASSERT_EQ(bone.kerfs.size(), 2U);
  const std::vector<double> out_mm3 = volumes_out(bone);
  ASSERT_EQ(out_mm3.size(), 1U);
  EXPECT_NEAR(out_mm3[0], half_mm3, 0.1) << "it was whole when it was taken";
  ASSERT_EQ(bone.pieces.size(), 3U) << "the rest, and its corner";
  const double across_mm = (rest_ends_mm - x_mm) / std::tan(lean_rad) + 4.0;
  const double slab_mm3 = 8.0 * 0.5 / std::cos(lean_rad) * across_mm;
  EXPECT_NEAR(bone.kerfs[1].removed_mm3, slab_mm3, 0.01 * slab_mm3);
  ASSERT_EQ(bone.kerfs[1].section.regions.size(), 1U);
  const auto& region = bone.kerfs[1].section.regions[0];
  // The slab's two planes reach further at the sawn face and at the bar's side.
  const double further_mm = 0.25 * (1.0 / std::tan(lean_rad) + std::tan(lean_rad));
  EXPECT_NEAR(region.max_mm.y - region.min_mm.y, across_mm / std::cos(lean_rad) + further_mm, 0.02);
  EXPECT_TRUE(bone.kerfs[1].is_finished());
  EXPECT_NEAR(sum_of(bone), bone.input_mm3(), 1e-6 * bone.input_mm3());
}

/// The blade stands half way in the piece, and goes on once that is out.
TEST_F(HalvedBar, KeepsNoPartOfAPieceThatWasTakenOutOffABlade) {
  constexpr double x_mm = 10.0;
  run_.glide(blade_down({x_mm, 12.0, 0.0}), 300);
  run_.glide(blade_down({x_mm, 0.0, 0.0}), 2000);
  run_.hold(200);
  run_.step({{CommandKind::PickUp, simulator::piece_freed_last, 0}});
  run_.hold(200);
  run_.glide(blade_down({x_mm, -9.0, 0.0}), 1000);
  run_.hold(500);
  run_.glide(blade_down({x_mm, 30.0, 0.0}), 400);
  run_.hold(20);
  ASSERT_EQ(run_.events(simulator::CutEventKind::PieceRemoved).size(), 1U);
  const RebuiltBone bone = rebuilt();
  ASSERT_EQ(bone.kerfs.size(), 2U);
  EXPECT_EQ(volumes_out(bone).size(), 2U);
  EXPECT_EQ(bone.pieces.size(), 3U);
  EXPECT_FALSE(bone.is_piece_out.at(0));
  EXPECT_NEAR(bone.piece_volumes_mm3.at(0), (rest_ends_mm + 15.0) * 64.0, 0.1);
  EXPECT_NEAR(sum_of(bone), bone.input_mm3(), 1e-6 * bone.input_mm3());
}

}  // namespace
}  // namespace hallux::assessment
