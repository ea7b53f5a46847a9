#include "simulator/jobs/live_cut.h"

#include <gtest/gtest.h>

#include "tests/simulator/step/simulation_run.h"
#include "tests/support/worlds.h"

namespace hallux::simulator {
namespace {

using tests::blade_down;

/// A block of 20 x 4 x 6 mm under a blade that is wider than it.
class LiveCutOfABlock : public testing::Test {
 protected:
  void freeze(std::int32_t kerf, double x_mm) {
    CutEvent event;
    event.kind = CutEventKind::PlaneFrozen;
    event.subject = kerf;
    event.pose = quantise(blade_down({x_mm, 2.0, 0.0}));
    cut_.apply(event);
  }
  /// The teeth in that kerf at `y_mm`: the block is through below -2.
  void saw(std::int32_t kerf, double x_mm, double y_mm, std::int64_t tick) {
    ToolSample sample;
    sample.tick = tick;
    sample.world_from_tool = quantise(bone_.world_from_bone * blade_down({x_mm, y_mm, 0.0}));
    sample.status = bit(ToolStatus::SawOn);
    sample.kerf = kerf;
    cut_.apply(sample);
  }
  void take_out_freed(std::int32_t kerf) {
    cut_.apply(JobRequest{0, JobKind::Pieces, kerf, 0});
    CutEvent event;
    event.kind = CutEventKind::PieceRemoved;
    event.subject = 1;
    cut_.apply(event);
  }

  void say(CutEventKind kind, std::int32_t subject, std::int64_t value = 0,
           const RigidTransform& pose = {}) {
    CutEvent event;
    event.kind = kind;
    event.subject = subject;
    event.value = value;
    event.pose = quantise(pose);
    cut_.apply(event);
  }
  /// Sawn through and parted; the piece is a fragment.
  void part() {
    freeze(0, 3.0);
    saw(0, 3.0, -4.0, 10);
    cut_.apply(JobRequest{0, JobKind::Pieces, 0, 10});
    say(CutEventKind::FragmentParted, 1, 0);
  }

  Bone bone_ = tests::cortical_bone(tests::solid_block({20.0, 4.0, 6.0}));
  const WholeBone whole_{solid_of(bone_)};
  LiveCut cut_{{whole_, bone_.world_from_bone}, Blade{}};
  SolidPatch patch_;
};

TEST_F(LiveCutOfABlock, HasNothingDueBeforeTheSawRunsInAKerf) {
  freeze(0, 3.0);
  EXPECT_FALSE(cut_.is_due());
  EXPECT_FALSE(cut_.take_base());
  EXPECT_FALSE(cut_.build_patch(patch_));
  EXPECT_TRUE(cut_.take_due().empty());
}

TEST_F(LiveCutOfABlock, ShowsTheFirstKerfOnTheBoneAsItWas) {
  freeze(0, 3.0);
  saw(0, 3.0, 1.0, 10);
  const std::optional<PatchBase> base = cut_.take_base();
  ASSERT_TRUE(base);
  EXPECT_TRUE(base->is_uncut());
  EXPECT_TRUE(cut_.build_patch(patch_));
  EXPECT_FALSE(patch_.triangles.empty());
  EXPECT_FALSE(cut_.is_due());
}

TEST_F(LiveCutOfABlock, KeepsTheBaseWhileTheSameKerfGrows) {
  freeze(0, 3.0);
  saw(0, 3.0, 1.0, 10);
  cut_.take_base();
  cut_.build_patch(patch_);
  saw(0, 3.0, 0.0, 20);
  EXPECT_TRUE(cut_.is_due());
  EXPECT_FALSE(cut_.take_base());
  EXPECT_TRUE(cut_.build_patch(patch_));
  EXPECT_TRUE(cut_.take_due().empty());
}

TEST_F(LiveCutOfABlock, LaysTheNextKerfOnABoneWithTheFirst) {
  freeze(0, 3.0);
  saw(0, 3.0, 0.0, 10);
  freeze(1, -3.0);
  saw(1, -3.0, 1.0, 20);
  const std::optional<PatchBase> base = cut_.take_base();
  ASSERT_TRUE(base);
  EXPECT_FALSE(base->is_uncut());
  EXPECT_LT(signed_volume_mm3(base->solid.mesh), 480.0 - 1.0);
  EXPECT_TRUE(cut_.build_patch(patch_));
}

TEST_F(LiveCutOfABlock, IsDueAsAWholeOnceAPieceWasTakenOut) {
  freeze(0, 3.0);
  saw(0, 3.0, -4.0, 10);
  take_out_freed(0);
  EXPECT_FALSE(cut_.take_base()) << "the base would hold the piece again";
  const std::vector<DueFragment> due = cut_.take_due();
  ASSERT_EQ(due.size(), 1U);
  EXPECT_NEAR(signed_volume_mm3(due[0].solid.mesh), 24.0 * (13.0 - 0.25), 1.0e-3);
  EXPECT_FALSE(cut_.is_due());
}

TEST_F(LiveCutOfABlock, TellsOfAPieceOnceItIsFreeAndOnceItIsGone) {
  freeze(0, 3.0);
  saw(0, 3.0, 0.0, 10);
  cut_.apply(JobRequest{0, JobKind::Pieces, 0, 10});
  std::optional<std::vector<FreedPiece>> pieces = cut_.take_free_pieces();
  ASSERT_TRUE(pieces);
  EXPECT_TRUE(pieces->empty()) << "it still holds";
  EXPECT_FALSE(cut_.take_free_pieces());
  saw(0, 3.0, -4.0, 20);
  cut_.apply(JobRequest{1, JobKind::Pieces, 0, 20});
  pieces = cut_.take_free_pieces();
  ASSERT_TRUE(pieces);
  ASSERT_EQ(pieces->size(), 1U);
  EXPECT_EQ(pieces->front().id, 1);
  EXPECT_NEAR(signed_volume_mm3(pieces->front().solid.mesh), 24.0 * (7.0 - 0.25), 1.0e-3);
  take_out_freed(0);
  pieces = cut_.take_free_pieces();
  ASSERT_TRUE(pieces);
  EXPECT_TRUE(pieces->empty());
}

TEST_F(LiveCutOfABlock, KnowsTheKerfInWhichTheTeethWereLast) {
  EXPECT_FALSE(cut_.kerf_at_hand());
  freeze(0, 3.0);
  saw(0, 3.0, 0.0, 10);
  freeze(1, -3.0);
  EXPECT_NEAR(cut_.kerf_at_hand()->plane.bone_from_kerf.translation_mm.x, 3.0, 1.0e-3);
  saw(1, -3.0, 1.0, 20);
  EXPECT_NEAR(cut_.kerf_at_hand()->plane.bone_from_kerf.translation_mm.x, -3.0, 1.0e-3);
  EXPECT_EQ(cut_.kerf_at_hand()->opened_mm.size(), 1U);
}

TEST_F(LiveCutOfABlock, ThatGoesOnWithoutABaseIsDueTwiceASecond) {
  freeze(0, 3.0);
  saw(0, 3.0, -4.0, 10);
  take_out_freed(0);
  cut_.take_due();
  saw(0, 3.0, -4.0, 400);
  EXPECT_FALSE(cut_.take_base());
  EXPECT_FALSE(cut_.build_patch(patch_));
  EXPECT_TRUE(cut_.take_due().empty()) << "the last one is 390 ms old";
  EXPECT_TRUE(cut_.is_due());
  saw(0, 3.0, -4.0, 510);
  EXPECT_FALSE(cut_.take_base());
  EXPECT_EQ(cut_.take_due().size(), 1U);
  EXPECT_FALSE(cut_.is_due());
}

TEST_F(LiveCutOfABlock, ShowsBothHalvesOnceAPieceIsAFragment) {
  part();
  const std::vector<DueFragment> due = cut_.take_due();
  ASSERT_EQ(due.size(), 2U);
  EXPECT_NEAR(signed_volume_mm3(due[0].solid.mesh), 24.0 * (13.0 - 0.25), 1.0e-3);
  EXPECT_NEAR(signed_volume_mm3(due[1].solid.mesh), 24.0 * (7.0 - 0.25), 1.0e-3);
  EXPECT_FALSE(cut_.is_due());
  EXPECT_TRUE(cut_.take_free_pieces()->empty()) << "it is all of its fragment";
  EXPECT_EQ(cut_.own_piece(1), 1);
}

TEST_F(LiveCutOfABlock, AGrippedFragmentLiesWhereTheSampleSaysAndThenWhereItWasLetGo) {
  part();
  say(CutEventKind::Gripped, 1);
  EXPECT_EQ(cut_.gripped(), 1);
  ToolSample sample;
  sample.tick = 20;
  sample.world_from_tool = quantise({{1.0, 0.0, 0.0, 0.0}, {1.0, 2.0, 3.0}});
  cut_.apply(sample);
  EXPECT_EQ(cut_.world_from_fragment(1).translation_mm.y, 2.0);
  const RigidTransform led{{1.0, 0.0, 0.0, 0.0}, {0.0, 0.0, 5.0}};
  say(CutEventKind::Released, 1, 0, led);
  EXPECT_EQ(cut_.gripped(), -1);
  const RigidTransform lies = bone_.world_from_bone * led;
  EXPECT_LT(length_of(cut_.world_from_fragment(1).translation_mm - lies.translation_mm), 1.0e-9);
}

TEST_F(LiveCutOfABlock, PatchesTheFragmentThatIsSawnAndMakesThePatchedOneWholeBefore) {
  freeze(0, 3.0);
  saw(0, 3.0, -4.0, 10);
  cut_.take_base();
  ASSERT_TRUE(cut_.build_patch(patch_));
  cut_.apply(JobRequest{0, JobKind::Pieces, 0, 10});
  say(CutEventKind::FragmentParted, 1, 0);
  cut_.take_due();
  say(CutEventKind::PlaneFrozen, 1, 1, blade_down({6.0, 2.0, 0.0}));
  saw(1, 6.0, 1.0, 20);
  const std::optional<PatchBase> base = cut_.take_base();
  ASSERT_TRUE(base);
  EXPECT_EQ(base->fragment, 1);
  EXPECT_FALSE(base->is_uncut()) << "a fragment is no bone as it was";
  EXPECT_NEAR(signed_volume_mm3(base->solid.mesh), 24.0 * (7.0 - 0.25), 1.0e-3);
  EXPECT_TRUE(cut_.build_patch(patch_));
  say(CutEventKind::PlaneFrozen, 2, 0, blade_down({-3.0, 2.0, 0.0}));
  saw(2, -3.0, 1.0, 30);
  EXPECT_EQ(cut_.take_base()->fragment, 0);
  const std::vector<DueFragment> due = cut_.take_due();
  ASSERT_EQ(due.size(), 1U);
  EXPECT_EQ(due[0].fragment, 1) << "its patch goes over into its mesh";
}

TEST_F(LiveCutOfABlock, OfAFragmentThatIsTakenOutNothingIsLeft) {
  part();
  cut_.take_due();
  say(CutEventKind::PieceRemoved, 1);
  const std::vector<DueFragment> due = cut_.take_due();
  ASSERT_EQ(due.size(), 1U);
  EXPECT_EQ(due[0].fragment, 1);
  EXPECT_TRUE(due[0].solid.mesh.triangles.empty());
  EXPECT_TRUE(cut_.is_out(1));
}

}  // namespace
}  // namespace hallux::simulator
