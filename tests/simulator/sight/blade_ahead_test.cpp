#include "simulator/sight/blade_ahead.h"

#include <gtest/gtest.h>

#include <array>

#include "tests/simulator/sight/sawn_block.h"
#include "tests/support/worlds.h"

namespace hallux::simulator {
namespace {

using tests::blade_at;
using tests::SawnBlock;

constexpr double step_mm = 0.1;

BladeAhead ahead_of(const SawnBlock& block, const tests::BladePlace& place,
                    std::span<const Bvh* const> taken_out = {}) {
  return look_ahead(blade_at(place), block.blade(), {block.bvh(), block.kerfs(), taken_out});
}

TEST(BladeAhead, TellsTheWayToTheBoneAndThroughIt) {
  const SawnBlock block;
  const BladeAhead air = ahead_of(block, {.y_mm = 14.0});
  ASSERT_TRUE(air.to_bone_mm && air.to_far_side_mm);
  EXPECT_NEAR(*air.to_bone_mm, 4.0, step_mm);
  EXPECT_NEAR(*air.to_far_side_mm, 24.0, step_mm);
  EXPECT_NEAR(air.beside_mm, 4.0, 1.0e-6);
}

TEST(BladeAhead, IsNothingBesideTheBone) {
  const SawnBlock block;
  const BladeAhead beside = ahead_of(block, {.x_mm = 26.0, .y_mm = 2.0});
  EXPECT_FALSE(beside.to_bone_mm || beside.to_far_side_mm);
  EXPECT_NEAR(beside.beside_mm, 6.0, 1.0e-6);
}

TEST(BladeAhead, InItsKerfTellsWhatIsLeft) {
  SawnBlock block;
  block.saw(block.freeze(0.0), {.y_mm = 3.0});
  const BladeAhead in_bone = ahead_of(block, {.y_mm = 3.0});
  ASSERT_TRUE(in_bone.to_bone_mm && in_bone.to_far_side_mm);
  EXPECT_NEAR(*in_bone.to_bone_mm, 0.0, 1.5 * step_mm);
  EXPECT_NEAR(*in_bone.to_far_side_mm, 13.0, step_mm);
  EXPECT_EQ(in_bone.beside_mm, 0.0);
  const BladeAhead drawn_back = ahead_of(block, {.y_mm = 8.0});
  EXPECT_NEAR(*drawn_back.to_bone_mm, 5.0, 1.5 * step_mm) << "through the slot that is open";
}

TEST(BladeAhead, AnswersForTheToothThatMeetsBoneFirstAndTheOneThatIsThroughLast) {
  const SawnBlock block;
  // Half of the tooth line beside the block.
  const BladeAhead half = ahead_of(block, {.y_mm = 11.0, .z_mm = 8.0});
  ASSERT_TRUE(half.to_bone_mm && half.to_far_side_mm);
  EXPECT_NEAR(*half.to_bone_mm, 1.0, step_mm);
  EXPECT_NEAR(*half.to_far_side_mm, 21.0, step_mm);
}

TEST(BladeAhead, DoesNotSeeAPieceThatIsOut) {
  const SawnBlock block;
  const Bvh upper_half(tests::moved(tests::solid_block({41.0, 10.0, 17.0}),
                                    {Quat{1.0, 0.0, 0.0, 0.0}, Vec3{0.0, 6.0, 0.0}}));
  const std::array<const Bvh*, 1> out{&upper_half};
  const BladeAhead ahead = ahead_of(block, {.y_mm = 12.0}, out);
  EXPECT_NEAR(*ahead.to_bone_mm, 11.0, step_mm);
}

}  // namespace
}  // namespace hallux::simulator
