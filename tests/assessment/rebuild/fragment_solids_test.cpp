/// A bar that is sawn in two, its halves moved and sawn again: rebuilt from what was recorded.
#include <gtest/gtest.h>

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

class MovedHalf : public testing::Test {
 protected:
  MovedHalf() {
    saw(cut_x_mm);
    run_.step({{CommandKind::Grip, simulator::piece_freed_last, 0}});
    run_.hold(3);
    run_.glide(blade_down({cut_x_mm, 30.0, 4.0}), 400);
    run_.step({{CommandKind::Release, 0, 0}});
    run_.hold(2);
  }

  void saw(double x_mm, double z_mm = 0.0) {
    run_.glide(blade_down({x_mm, 12.0, z_mm}), 300);
    run_.glide(blade_down({x_mm, -9.0, z_mm}), 2000);
    run_.hold(1500);
    run_.glide(blade_down({x_mm, 30.0, z_mm}), 400);
    run_.hold(20);
  }
  RebuiltBone rebuilt() const { return rebuild(bone_, {}, run_.recording()); }

  simulator::Bone bone_ = tests::cancellous_bone(tests::solid_block({30.0, 8.0, 8.0}));
  tests::SimulationRun run_{bone_, blade_down({cut_x_mm, 12.0, 0.0})};
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
  EXPECT_NEAR(bone.input_mm3, bar_mm3, 1e-9);
  EXPECT_NEAR(sum_of(bone), bone.input_mm3, 1e-6 * bone.input_mm3);
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
  EXPECT_NEAR(sum_of(bone), bone.input_mm3, 1e-6 * bone.input_mm3);
}

TEST_F(MovedHalf, LeavesABoneThatIsSawnOn) {
  saw(-5.0);
  const RebuiltBone bone = rebuilt();
  ASSERT_EQ(bone.kerfs.size(), 2U);
  EXPECT_EQ(bone.fields.fragment_of(1), 0);
  EXPECT_EQ(bone.fragments[0].piece_count, 2U);
  EXPECT_EQ(bone.fragments[1].piece_count, 1U);
  EXPECT_NEAR(sum_of(bone), bone.input_mm3, 1e-6 * bone.input_mm3);
}

TEST_F(MovedHalf, IsTheSameFromKeptFields) {
  saw(10.0, 4.0);
  const OpenedFields opened = opened_fields({}, bone_.world_from_bone, run_.recording());
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
  EXPECT_NEAR(sum_of(bone), bone.input_mm3, 1e-6 * bone.input_mm3);
}

}  // namespace
}  // namespace hallux::assessment
