#include "simulator/cutting/field/tile_pool.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "simulator/cutting/field/kerf_set.h"

namespace hallux::simulator {
namespace {

constexpr float closed_mm = -0.05F;

bool is_closed(const float* tile) {
  return std::all_of(tile, tile + TilePool::nodes_per_tile,
                     [](float value_mm) { return value_mm == closed_mm; });
}

TEST(TilePool, HandsOutClosedTilesThatNobodyElseHas) {
  TilePool pool(3, closed_mm);
  std::vector<float*> tiles;
  for (int i = 0; i < 3; ++i) {
    tiles.push_back(pool.take());
    EXPECT_TRUE(is_closed(tiles.back()));
    std::fill_n(tiles.back(), TilePool::nodes_per_tile, 0.01F * static_cast<float>(i));
  }
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(tiles[static_cast<std::size_t>(i)][0], 0.01F * static_cast<float>(i));
    EXPECT_EQ(tiles[static_cast<std::size_t>(i)][TilePool::nodes_per_tile - 1],
              0.01F * static_cast<float>(i));
  }
  EXPECT_TRUE(is_closed(pool.closed_tile()));
}

TEST(TilePool, TouchesNoMoreThanWasTakenOrMadeReady) {
  TilePool pool(1000, closed_mm);
  EXPECT_EQ(pool.touched_count(), 0U);
  pool.take();
  EXPECT_EQ(pool.touched_count(), 1U);
  pool.make_ready(10, 3);
  EXPECT_EQ(pool.touched_count(), 4U);
  pool.make_ready(10, 100);
  EXPECT_EQ(pool.touched_count(), 11U);
  for (int i = 0; i < 4; ++i) EXPECT_TRUE(is_closed(pool.take()));
  EXPECT_EQ(pool.touched_count(), 11U);
  pool.make_ready(5000, 5000);
  EXPECT_EQ(pool.touched_count(), 1000U) << "all there are";
}

TEST(TilePoolDeathTest, StopsWhereMoreAreTakenThanThereAre) {
  TilePool pool(1, closed_mm);
  pool.take();
  EXPECT_DEATH(pool.take(), "taken_count_ < tile_count_");
}

/// How many of a grid's tiles hold a node of the window.
std::size_t tiles_in(const FieldWindow& window) {
  const auto over = [](std::int32_t first, std::int32_t last) {
    const std::int32_t tiles =
        (last - 1) / TilePool::nodes_on_a_side - first / TilePool::nodes_on_a_side + 1;
    return static_cast<std::size_t>(tiles);
  };
  return over(window.u_first, window.u_last) * over(window.v_first, window.v_last);
}

class SharedPool : public testing::Test {
 protected:
  FieldWindow stamp(KerfField& field, const Vec2& tip_mm) const {
    FieldWindow changed;
    const PlanarPose pose{tip_mm, {1.0, 0.0}};
    field.stamp(blade_, pose, pose, changed);
    return changed;
  }

  FieldGrid grid_;
  Blade blade_{.width_mm = 9.0, .depth_mm = 12.0, .kerf_mm = 0.5};
  TilePool pool_{2 * KerfField::tiles_of(grid_), KerfField::closed_mm(grid_)};
};

TEST_F(SharedPool, AFieldTakesTilesOnlyWhereABladeCameBy) {
  KerfField field(grid_, pool_);
  EXPECT_EQ(pool_.taken_count(), 0U);
  const FieldWindow changed = stamp(field, {3.0, 1.0});
  EXPECT_EQ(pool_.taken_count(), tiles_in(changed)) << "a blade square to the grid";
  stamp(field, {3.0, 1.0});
  EXPECT_EQ(pool_.taken_count(), tiles_in(changed)) << "the same again rises nowhere";
  EXPECT_LT(pool_.taken_count(), KerfField::tiles_of(grid_) / 20);
}

TEST_F(SharedPool, FieldsDoNotSeeEachOther) {
  KerfField first(grid_, pool_), second(grid_, pool_);
  stamp(first, {3.0, 1.0});
  stamp(second, {-3.0, 1.0});
  KerfField alone(grid_);
  stamp(alone, {-3.0, 1.0});
  for (std::int32_t u = 0; u < grid_.u_count; ++u) {
    for (std::int32_t v = 0; v < grid_.v_count; ++v) {
      ASSERT_EQ(second.at(u, v), alone.at(u, v)) << u << ' ' << v;
    }
  }
  EXPECT_TRUE(first.is_open({2.0, 1.0}));
  EXPECT_FALSE(second.is_open({2.0, 1.0}));
}

TEST_F(SharedPool, ACopyOfAFieldHasItsOwnNodes) {
  KerfField field(grid_, pool_);
  stamp(field, {3.0, 1.0});
  const KerfField before = field;
  stamp(field, {8.0, 1.0});
  EXPECT_TRUE(field.is_open({7.0, 1.0}));
  EXPECT_FALSE(before.is_open({7.0, 1.0}));
  EXPECT_TRUE(before.is_open({2.0, 1.0}));
}

TEST_F(SharedPool, HasATileForEveryNodeOfEveryField) {
  KerfField first(grid_, pool_), second(grid_, pool_);
  const Blade all{.width_mm = 200.0, .depth_mm = 200.0, .kerf_mm = 0.5};
  const PlanarPose pose{{100.0, 0.0}, {1.0, 0.0}};
  FieldWindow changed;
  for (KerfField* const field : {&first, &second}) field->stamp(all, pose, pose, changed);
  EXPECT_EQ(pool_.taken_count(), 2 * KerfField::tiles_of(grid_));
  EXPECT_GT(second.at(0, 0), 0.0F);
  EXPECT_GT(second.at(grid_.u_count - 1, grid_.v_count - 1), 0.0F);
}

TEST(KerfSetMemory, FollowsWhatIsOpenedAndNotHowManyKerfsThereMayBe) {
  KerfSet kerfs({}, RigidTransform{});
  EXPECT_EQ(kerfs.tiles().touched_count(), 0U);
  ToolSample sample;
  sample.status = bit(ToolStatus::SawOn);
  for (std::int32_t kerf = 0; kerf < kerf_limit; ++kerf) {
    sample.kerf = kerfs.freeze({});
    for (sample.tick = 0; sample.tick < 100; ++sample.tick) {
      sample.world_from_tool.translation_um[0] = static_cast<std::int32_t>(sample.tick) * 50;
      kerfs.apply(sample);
    }
  }
  const std::size_t opened_bytes =
      kerfs.tiles().touched_count() * TilePool::nodes_per_tile * sizeof(float);
  EXPECT_GT(opened_bytes, 0U);
  EXPECT_LT(opened_bytes, std::size_t{20} << 20U) << "whole grids take 164 MiB";
}

}  // namespace
}  // namespace hallux::simulator
