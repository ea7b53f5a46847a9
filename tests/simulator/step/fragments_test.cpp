/// A bar of bone sawn in two, and its free half in the forceps.
#include <gtest/gtest.h>

#include <cmath>

#include "simulator/base/units.h"
#include "tests/simulator/step/simulation_run.h"
#include "tests/support/worlds.h"

namespace hallux::simulator {
namespace {

using tests::blade_down;
using tests::SimulationRun;

constexpr double length_mm = 30.0, height_mm = 8.0, width_mm = 8.0;
constexpr double cut_x_mm = 5.0, kerf_mm = 0.5;
constexpr Command grip_last{CommandKind::Grip, piece_freed_last, 0};
constexpr Command release{CommandKind::Release, 0, 0};
constexpr Command impact{CommandKind::Impact, 0, 0};

Bone bar() { return tests::cancellous_bone(tests::solid_block({length_mm, height_mm, width_mm})); }

/// The bar with a kerf through it at x = 5: the part beyond, of 9.75 mm, is piece 1.
class SawnBar : public testing::Test {
 protected:
  SawnBar() {
    run_.glide(blade_down({cut_x_mm, -9.0, 0.0}), 2000);
    run_.hold(1500);
    run_.glide(above({cut_x_mm, 30.0, 0.0}), 400);
    run_.hold(20);
  }

  static RigidTransform above(const Vec3& place_mm) { return blade_down(place_mm); }
  /// The forceps move by so much from where they closed, in so many ticks.
  void lead(const Vec3& by_mm, std::int64_t ticks) {
    place_mm_ += by_mm;
    run_.glide(above(place_mm_), ticks);
  }
  void grip() {
    run_.step({grip_last});
    run_.hold(3);
  }
  RigidTransform bone_from_piece() const {
    return transform_from(run_.events(CutEventKind::Released).back().pose);
  }

  Bone bone_ = bar();
  SimulationRun run_{bone_, blade_down({cut_x_mm, 12.0, 0.0})};
  Vec3 place_mm_{cut_x_mm, 30.0, 0.0};
};

TEST_F(SawnBar, TheFreeHalfBecomesAFragmentWhenItIsGripped) {
  ASSERT_EQ(run_.events(CutEventKind::PieceFreed).size(), 1U);
  grip();
  const auto parted = run_.events(CutEventKind::FragmentParted);
  ASSERT_EQ(parted.size(), 1U);
  EXPECT_EQ(parted[0].subject, 1);
  EXPECT_EQ(parted[0].value, 0);
  const auto gripped = run_.events(CutEventKind::Gripped);
  ASSERT_EQ(gripped.size(), 1U);
  EXPECT_EQ(gripped[0].subject, 1);
  EXPECT_EQ(gripped[0].pose, QuantisedPose{});
  EXPECT_EQ(run_.simulation().gripped(), 1);
}

TEST_F(SawnBar, TheGrippedHalfFollowsTheHandAndIsTheToolOfTheRecord) {
  grip();
  lead({0.0, 0.0, 5.0}, 500);
  run_.hold(200);
  const RigidTransform piece = run_.bone_from_tool();
  EXPECT_NEAR(length_of(piece.translation_mm - Vec3(0.0, 0.0, 5.0)), 0.0, 0.01);
  run_.step({release});
  EXPECT_EQ(run_.simulation().gripped(), -1);
  EXPECT_NEAR(length_of(bone_from_piece().translation_mm - Vec3(0.0, 0.0, 5.0)), 0.0, 0.01);
}

TEST_F(SawnBar, TheHalvesDoNotEnterEachOther) {
  grip();
  lead({-3.0, 0.0, 0.0}, 600);
  run_.hold(300);
  EXPECT_LT(run_.force_in_bone_newton().x * -1.0, 0.0) << "the hand is pushed back";
  run_.step({release});
  const RigidTransform piece = bone_from_piece();
  EXPECT_NEAR(piece.translation_mm.x, -kerf_mm, 0.02) << "the kerf is closed, no more";
  EXPECT_NEAR(piece.translation_mm.y, 0.0, 0.05);
}

TEST_F(SawnBar, ImpactingClosesTheKerfUntilTheFacesTouch) {
  grip();
  lead({0.0, 0.0, 3.0}, 300);
  run_.step({impact});
  run_.hold(1200);
  run_.step({release});
  const RigidTransform piece = bone_from_piece();
  EXPECT_NEAR(piece.translation_mm.x, -kerf_mm, 0.02);
  EXPECT_NEAR(piece.translation_mm.z, 3.0, 0.05);
  EXPECT_NEAR(2.0 * length_of(Vec3(piece.rotation.x, piece.rotation.y, piece.rotation.z)), 0.0,
              radian_from_degree(0.3))
      << "flat walls lie flat";
}

TEST_F(SawnBar, ABladeAcrossBothHalvesCutsEachInItsOwnFrame) {
  grip();
  lead({0.0, 0.0, 4.0}, 400);
  run_.step({impact});
  run_.hold(1200);
  run_.step({release});
  // Along the bar, through its top: the blade is as wide as 12 mm and stands over both halves.
  const Quat along = rotation_from_axes(Vec3{0.0, -1.0, 0.0}, Vec3{1.0, 0.0, 0.0});
  const auto at = [&](double y_mm) {
    return RigidTransform{along, Vec3(cut_x_mm - 0.25, y_mm, 2.0)};
  };
  run_.glide(at(20.0), 300);
  run_.glide(at(0.0), 2500);
  run_.hold(4000);
  const auto frozen = run_.events(CutEventKind::PlaneFrozen);
  ASSERT_EQ(frozen.size(), 3U) << "one that parted the bar, and one in each half";
  EXPECT_NE(frozen[1].value, frozen[2].value);
  const KerfSet& kerfs = run_.simulation().kerfs();
  EXPECT_EQ(kerfs.one_cut_with(1).count(), 2);
  // The same place of the world, in either frame.
  const RigidTransform piece = bone_from_piece();
  const std::int32_t in_bone = frozen[1].value == 0 ? 1 : 2, in_piece = 3 - in_bone;
  const Vec3 bone_place{cut_x_mm - 2.0, 3.0, 2.0};
  const Vec3 piece_place = transform_point(inverse(piece), Vec3{cut_x_mm + 3.0, 3.0, 2.0});
  EXPECT_TRUE(kerfs.is_open(kerfs.kerfs_of(0), bone_place));
  EXPECT_TRUE(kerfs.is_open(kerfs.kerfs_of(1), piece_place));
  EXPECT_EQ(kerfs.fragment_of(in_piece), 1);
}

TEST_F(SawnBar, APieceThatWasMovedCanBeTakenOut) {
  grip();
  lead({0.0, 0.0, 5.0}, 500);
  run_.step({release});
  run_.step({{CommandKind::PickUp, 1, 0}});
  EXPECT_EQ(run_.events(CutEventKind::PieceRemoved).size(), 1U);
  run_.glide(blade_down({10.0, 12.0, 5.0}), 300);
  const auto contacts = run_.events(CutEventKind::Contact).size();
  run_.glide(blade_down({10.0, -6.0, 5.0}), 600);
  EXPECT_EQ(run_.events(CutEventKind::Contact).size(), contacts) << "nothing is there any more";
}

TEST_F(SawnBar, RefusesToGripWhatCannotBeMoved) {
  const auto refused = [&](std::int32_t piece) {
    run_.step({{CommandKind::Grip, piece, 0}});
    run_.hold(3);
    const auto events = run_.events(CutEventKind::GripRefused);
    return events.empty() ? -1 : events.back().subject;
  };
  EXPECT_EQ(refused(7), static_cast<std::int32_t>(GripRefusal::NoSuchPiece));
  EXPECT_EQ(refused(0), static_cast<std::int32_t>(GripRefusal::BoneItself));
  grip();
  EXPECT_EQ(refused(1), static_cast<std::int32_t>(GripRefusal::HandsFull));
  EXPECT_EQ(run_.simulation().gripped(), 1) << "still held";
}

TEST_F(SawnBar, APieceIsNotGrippedWhileTheBladeStandsInBone) {
  run_.glide(blade_down({0.0, 12.0, 0.0}), 300);
  run_.glide(blade_down({0.0, 0.0, 0.0}), 1200);
  run_.step({grip_last});
  run_.hold(3);
  ASSERT_EQ(run_.events(CutEventKind::GripRefused).size(), 1U);
  EXPECT_EQ(run_.events(CutEventKind::GripRefused)[0].subject,
            static_cast<std::int32_t>(GripRefusal::ToolInBone));
}

TEST_F(SawnBar, FinishingLetsGo) {
  grip();
  lead({0.0, 0.0, 2.0}, 200);
  run_.step({{CommandKind::Finish, 0, 0}});
  const auto kinds = tests::kinds_of(run_.recording());
  ASSERT_GE(kinds.size(), 2U);
  EXPECT_EQ(kinds[kinds.size() - 2], CutEventKind::Released);
  EXPECT_EQ(kinds.back(), CutEventKind::Finished);
}

TEST_F(SawnBar, NoPieceGoesFasterThanAHand) {
  grip();
  run_.glide(above({200.0, 300.0, 100.0}), 3);
  Vec3 last = run_.bone_from_tool().translation_mm;
  for (int i = 0; i < 200; ++i) {
    run_.step();
    const Vec3 now = run_.bone_from_tool().translation_mm;
    EXPECT_LE(length_of(now - last), 2.0);
    last = now;
  }
}

}  // namespace
}  // namespace hallux::simulator
