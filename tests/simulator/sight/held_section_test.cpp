#include "simulator/sight/held_section.h"

#include <gtest/gtest.h>

#include "tests/simulator/sight/sawn_block.h"

namespace hallux::simulator {
namespace {

using tests::SawnBlock;

/// Of the grid: 0.2 mm along an edge of some 16 mm.
constexpr double share_of_grid = 0.02;
constexpr double grid_mm = 0.2;

/// In the block's own axes.
Vec3 in_block(const SawnBlock& block, std::int32_t kerf, const Vec2& place_mm) {
  return transform_point(block.kerfs().plane(kerf).bone_from_kerf, Vec3(place_mm, 0.0));
}

HeldSection held(const SawnBlock& block, std::int32_t kerf,
                 const std::optional<PlaneLimit>& limit = {}) {
  return held_section(block.section(kerf), block.kerfs(), kerf, limit);
}

TEST(HeldSection, IsAllOfItBeforeTheBladeHasOpenedAny) {
  SawnBlock block;
  const std::int32_t kerf = block.freeze(0.0);
  const HeldSection all = held(block, kerf);
  EXPECT_EQ(all.share, 1.0);
  EXPECT_NEAR(in_block(block, kerf, all.section_middle_mm).y, 0.0, grid_mm);
  EXPECT_NEAR(all.depth_mm, 8.0, 2.0 * grid_mm) << "half of the narrow side";
}

TEST(HeldSection, IsTheShareThatAStrokeOfANarrowBladeLeaves) {
  SawnBlock block;
  const std::int32_t kerf = block.freeze(0.0);
  block.saw(kerf, {.y_mm = -11.0, .z_mm = 3.0});
  const HeldSection strip = held(block, kerf);
  // The blade took z from -2 to 8 of -8 to 8.
  EXPECT_NEAR(strip.share, 6.0 / 16.0, share_of_grid);
  const Vec3 middle_mm = in_block(block, kerf, strip.middle_mm);
  EXPECT_NEAR(middle_mm.y, 0.0, grid_mm);
  EXPECT_NEAR(middle_mm.z, -5.0, grid_mm);
  EXPECT_NEAR(in_block(block, kerf, strip.deepest_mm).z, -5.0, 2.0 * grid_mm);
  EXPECT_NEAR(strip.depth_mm, 3.0, 2.0 * grid_mm);
}

TEST(HeldSection, IsNothingOnceTheSectionIsOpenFromEdgeToEdge) {
  SawnBlock block;
  const std::int32_t kerf = block.freeze(0.0);
  block.saw(kerf, {.y_mm = -11.0, .z_mm = 4.0});
  block.saw(kerf, {.y_mm = -11.0, .z_mm = -4.0});
  const HeldSection none = held(block, kerf);
  EXPECT_EQ(none.share, 0.0);
  EXPECT_EQ(none.depth_mm, 0.0);
}

TEST(HeldSection, TellsASliverAlongTheRimThatLiesBetweenThePlacesOfTheGrid) {
  SawnBlock block;
  const std::int32_t kerf = block.freeze(0.0);
  for (const double z_mm : {4.0, -4.0}) block.saw(kerf, {.y_mm = -9.98, .z_mm = z_mm});
  const HeldSection sliver = held(block, kerf);
  EXPECT_GT(sliver.share, 0.0);
  EXPECT_LT(sliver.share, 0.001);
  EXPECT_NEAR(in_block(block, kerf, sliver.deepest_mm).y, -10.0, 0.01);
}

TEST(HeldSection, AsksOnlyAboutTheSideOfAHingeThatIsToBeSawn) {
  SawnBlock block;
  const std::int32_t kerf = block.freeze(0.0);
  block.saw(kerf, {.y_mm = -7.0, .z_mm = 4.0});
  block.saw(kerf, {.y_mm = -7.0, .z_mm = -4.0});
  EXPECT_NEAR(held(block, kerf).share, 3.0 / 20.0, share_of_grid);
  // The kerf's x looks down from where it was frozen, 12 mm up.
  const HeldSection within = held(block, kerf, PlaneLimit{{1.0, 0.0}, 12.0 + 6.5});
  EXPECT_EQ(within.share, 0.0);
}

TEST(HeldSection, DoesNotCountWhatAnotherKerfHasOpened) {
  SawnBlock block;
  const std::int32_t first = block.freeze(0.0);
  block.saw(first, {.y_mm = -11.0, .z_mm = 4.0});
  const std::int32_t second = block.freeze(0.1);
  block.saw(second, {.x_mm = 0.1, .y_mm = -11.0, .z_mm = -4.0});
  EXPECT_EQ(held(block, second).share, 0.0);
  EXPECT_EQ(held(block, first).share, 0.0);
}

TEST(HeldSection, OfAPlaneThatMissesTheBoneIsNothing) {
  SawnBlock block;
  const std::int32_t kerf = block.freeze(30.0);
  EXPECT_EQ(held(block, kerf).share, 0.0);
  EXPECT_TRUE(held(block, kerf).regions.empty());
}

}  // namespace
}  // namespace hallux::simulator
