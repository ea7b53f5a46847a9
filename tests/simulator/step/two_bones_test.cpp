/// Two bones in one wound, each in a frame of its own: sawn at once, gripped, wired to each other.
#include <gtest/gtest.h>

#include <array>

#include "simulator/loop/replay.h"
#include "tests/simulator/contact/bore/bore_world.h"
#include "tests/simulator/step/simulation_run.h"
#include "tests/support/worlds.h"

namespace hallux::simulator {
namespace {

using tests::blade_down;
using tests::pointing;
using tests::SimulationRun;

constexpr std::int32_t wire = 1;
const Vec3 down{0.0, -1.0, 0.0};

Tray tray() {
  const std::array<Tool, 1> further{WireDriver{}};
  return {Saw{.blade = {.width_mm = 18.0}}, further};
}

/// A bar beside the first one along z, turned upside down in its own frame.
Bone second_bar(const Bone& first, const RigidTransform& first_from_second) {
  Bone bone = tests::cancellous_bone(tests::solid_block({30.0, 8.0, 6.0}));
  bone.world_from_bone = first.world_from_bone * first_from_second;
  return bone;
}

class TwoBars : public testing::Test {
 protected:
  SimulationSetup setup() const {
    SimulationSetup setup{first_, tray()};
    setup.further_bones = {&second_};
    return setup;
  }
  std::size_t count(CutEventKind kind) const { return run_.events(kind).size(); }
  /// Through both, at x = 5.
  void saw_both() {
    run_.glide(blade_down({5.0, -9.0, 3.5}), 3000);
    run_.hold(4000);
    run_.glide(blade_down({5.0, 30.0, 3.5}), 400);
    run_.hold(20);
  }

  RigidTransform first_from_second_{rotation_about(Vec3{1.0, 0.0, 0.0}, 3.14159265358979),
                                    Vec3{0.0, 0.0, 7.5}};
  Bone first_ = tests::cancellous_bone(tests::solid_block({30.0, 8.0, 8.0}));
  Bone second_ = second_bar(first_, first_from_second_);
  SimulationRun run_{setup(), blade_down({5.0, 12.0, 3.5})};
};

TEST_F(TwoBars, OneStrokeCutsBothEachInItsOwnFrame) {
  saw_both();
  const auto frozen = run_.events(CutEventKind::PlaneFrozen);
  ASSERT_EQ(frozen.size(), 2U);
  EXPECT_EQ(frozen[0].value + frozen[1].value, 1) << "one in each";
  const KerfSet& kerfs = run_.simulation().kerfs();
  EXPECT_TRUE(kerfs.is_open(kerfs.kerfs_of(0), {5.0, 0.0, 0.0}));
  EXPECT_TRUE(kerfs.is_open(kerfs.kerfs_of(1), {5.0, 0.0, 0.0}));
  EXPECT_EQ(kerfs.one_cut_with(0).count(), 2);
}

TEST_F(TwoBars, PiecesOfBothAreNumberedAndAllVolumesAddUp) {
  saw_both();
  const auto freed = run_.events(CutEventKind::PieceFreed);
  ASSERT_EQ(freed.size(), 2U);
  EXPECT_EQ(freed[0].subject + freed[1].subject, 2 + 3) << "after the bones, 0 and 1";
  double sum_mm3 = 0.0;
  for (std::int32_t fragment = 0; fragment < 2; ++fragment) {
    for (const PieceBody& piece : run_.jobs().geometry().pieces(fragment))
      sum_mm3 += piece.volume_mm3;
  }
  EXPECT_NEAR(sum_mm3, (30.0 - 0.5) * (8.0 * 8.0 + 8.0 * 6.0), 1.0e-6 * 30.0 * 8.0 * 14.0);
  EXPECT_TRUE(replay(run_.recording(), setup()).is_identical);
}

TEST_F(TwoBars, APieceOfTheSecondIsLedInItsOwnFrame) {
  saw_both();
  const auto freed = run_.events(CutEventKind::PieceFreed);
  const KerfSet& kerfs = run_.simulation().kerfs();
  for (const CutEvent& event : freed) {
    run_.step({{CommandKind::Grip, event.subject, 0}});
    run_.hold(5);
    const std::int32_t fragment = run_.simulation().gripped();
    ASSERT_GE(fragment, 2);
    if (kerfs.fragments()[fragment].bone == 1) break;
    run_.step({{CommandKind::Release, 0, 0}});
    run_.hold(5);
  }
  const std::int32_t fragment = run_.simulation().gripped();
  ASSERT_EQ(kerfs.fragments()[fragment].bone, 1);
  run_.glide(blade_down({5.0, 35.0, 3.5}), 500);
  run_.hold(200);
  run_.step({{CommandKind::Release, 0, 0}});
  const RigidTransform moved = transform_from(run_.events(CutEventKind::Released).back().pose);
  EXPECT_NEAR(moved.translation_mm.y, -5.0, 0.05) << "up in the world is down in its frame";
  EXPECT_TRUE(replay(run_.recording(), setup()).is_identical);
}

TEST_F(TwoBars, ABoneIsNotGripped) {
  run_.glide(blade_down({5.0, 30.0, 3.5}), 200);
  run_.step({{CommandKind::Grip, 1, 0}});
  run_.hold(3);
  ASSERT_EQ(count(CutEventKind::GripRefused), 1U);
  EXPECT_EQ(run_.events(CutEventKind::GripRefused)[0].subject,
            static_cast<std::int32_t>(GripRefusal::BoneItself));
}

TEST_F(TwoBars, AWireThroughBothBoresInEach) {
  const Vec3 ahead{0.0, 0.0, 1.0};
  run_.glide(pointing({-5.0, 0.0, -30.0}, ahead), 400);
  run_.step({{CommandKind::ChooseTool, wire, 0}});
  run_.hold(3);
  run_.glide(pointing({-5.0, 0.0, 18.0}, ahead), 6000);
  for (int i = 0; i < 12000 && run_.bone_from_tool().translation_mm.z < 11.0; ++i) run_.hold(1);
  const auto begun = run_.events(CutEventKind::BoreBegun);
  ASSERT_EQ(begun.size(), 2U);
  EXPECT_EQ(begun[0].value, 0);
  EXPECT_EQ(begun[1].value, 1);
  EXPECT_EQ(count(CutEventKind::BoreThrough), 1U) << "the gap between them is no far side";
  run_.step({{CommandKind::LeaveImplant, 0, 0}});
  EXPECT_EQ(count(CutEventKind::ImplantLeft), 1U);
  EXPECT_TRUE(replay(run_.recording(), setup()).is_identical);
}

}  // namespace
}  // namespace hallux::simulator
