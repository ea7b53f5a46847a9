#include "simulator/cutting/field/region_outline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/allocation_counter.h"
#include "tests/support/outline_area.h"

namespace hallux::tests {
namespace {

using namespace simulator;

constexpr double spacing_mm = 0.05;
const FieldGrid grid{
    .origin_mm = Vec2(-12.0), .spacing_mm = spacing_mm, .u_count = 481, .v_count = 481};

PlanarPose pose_at(double u_mm, double v_mm, double turn_rad = 0.0) {
  return {Vec2(u_mm, v_mm), Vec2(std::cos(turn_rad), std::sin(turn_rad))};
}

void open_box(KerfField& field, const Vec2& low_mm, const Vec2& high_mm) {
  FieldWindow changed;
  const PlanarPose pose{Vec2(high_mm.x, 0.5 * (low_mm.y + high_mm.y))};
  field.stamp({.width_mm = high_mm.y - low_mm.y, .depth_mm = high_mm.x - low_mm.x}, pose, pose,
              changed);
}

double loop_area_mm2(const RegionOutline& outline, std::size_t loop) {
  const auto first = outline.corners_mm.begin() + (loop == 0 ? 0 : outline.loop_ends[loop - 1]);
  const std::vector<Vec2> corners_mm(first, outline.corners_mm.begin() + outline.loop_ends[loop]);
  return area_mm2({corners_mm, {static_cast<std::uint32_t>(corners_mm.size())}});
}

std::size_t crossings_of(const KerfField& field) {
  std::size_t count = 0;
  for (std::int32_t u = 1; u < field.grid().u_count; ++u) {
    for (std::int32_t v = 1; v < field.grid().v_count; ++v) {
      const bool is_open = field.at(u, v) > 0.0F;
      count += is_open != (field.at(u - 1, v) > 0.0F) ? 1U : 0U;
      count += is_open != (field.at(u, v - 1) > 0.0F) ? 1U : 0U;
    }
  }
  return count;
}

// Marching squares sees a rectangle's corner only through the cell it lies in and those beside it:
// each corner is cut off by less than a cell's area on each of them, and nowhere else is anything
// lost but the rounding of floats and the corner level, 1e-8 mm along the sides.
constexpr double cut_corners_mm2 = 4.0 * 2.0 * spacing_mm * spacing_mm;

TEST(RegionOutline, OfNothingHasNoLoops) {
  const RegionOutline outline = outline_of(KerfField(grid));
  EXPECT_TRUE(outline.corners_mm.empty());
  EXPECT_TRUE(outline.loop_ends.empty());
  EXPECT_EQ(area_mm2(outline), 0.0);
}

TEST(RegionOutline, OfARectangleOffTheNodesHasItsAreaButForTheCorners) {
  for (const double turn_rad : {0.0, 0.0011, 0.3, 0.785398, 1.2, -2.0}) {
    KerfField field(grid);
    FieldWindow changed;
    const PlanarPose pose =
        pose_at(3.017 * std::cos(turn_rad), 3.017 * std::sin(turn_rad), turn_rad);
    field.stamp({.width_mm = 7.003, .depth_mm = 6.011}, pose, pose, changed);
    const RegionOutline outline = outline_of(field);
    const double expected_mm2 = 7.003 * 6.011;
    EXPECT_EQ(outline.loop_ends.size(), 1U);
    EXPECT_LE(area_mm2(outline), expected_mm2 + 1e-6) << turn_rad;
    EXPECT_GE(area_mm2(outline), expected_mm2 - cut_corners_mm2 - 1e-6) << turn_rad;
    // Sides of 120 and 140 nodes are single segments, but where one passes a node by less than the
    // least share.
    EXPECT_LE(outline.corners_mm.size(), 24U) << turn_rad;
  }
}

TEST(RegionOutline, SidesLieWhereTheBladesDo) {
  KerfField field(grid);
  open_box(field, Vec2(-4.013, -3.021), Vec2(5.017, 2.009));
  const RegionOutline outline = outline_of(field);
  double low_mm = 1.0, high_mm = -1.0;
  for (const Vec2& corner_mm : outline.corners_mm) {
    low_mm = std::min(low_mm, corner_mm.x);
    high_mm = std::max(high_mm, corner_mm.x);
  }
  // Floats near a spacing are 4e-9 mm apart, and corners lie on the level of 1e-8 mm.
  EXPECT_NEAR(low_mm, -4.013, 2e-8);
  EXPECT_NEAR(high_mm, 5.017, 2e-8);
}

TEST(RegionOutline, KeepsTheRegionOnTheLeftOfOuterLoopsAndHoles) {
  KerfField field(grid);
  open_box(field, Vec2(-6.0, -6.0), Vec2(6.0, -4.0));
  open_box(field, Vec2(-6.0, 4.0), Vec2(6.0, 6.0));
  open_box(field, Vec2(-6.0, -6.0), Vec2(-4.0, 6.0));
  EXPECT_EQ(outline_of(field).loop_ends.size(), 1U);
  open_box(field, Vec2(4.0, -6.0), Vec2(6.0, 6.0));
  open_box(field, Vec2(-1.0, -1.0), Vec2(1.0, 1.0));
  const RegionOutline outline = outline_of(field);
  ASSERT_EQ(outline.loop_ends.size(), 3U);
  std::vector<double> areas_mm2;
  for (std::size_t loop = 0; loop < 3; ++loop) areas_mm2.push_back(loop_area_mm2(outline, loop));
  std::sort(areas_mm2.begin(), areas_mm2.end());
  EXPECT_NEAR(areas_mm2[0], -64.0, cut_corners_mm2 + 16e-3);  // corners on nodes: 0.5 um a side
  EXPECT_NEAR(areas_mm2[1], 4.0, cut_corners_mm2 + 8e-3);
  EXPECT_NEAR(areas_mm2[2], 144.0, cut_corners_mm2 + 24e-3);
  open_box(field, Vec2(-4.5, -4.5), Vec2(4.5, 4.5));
  const RegionOutline filled = outline_of(field);
  EXPECT_EQ(filled.loop_ends.size(), 1U);
  EXPECT_NEAR(area_mm2(filled), 144.0, cut_corners_mm2 + 24e-3);
}

TEST(RegionOutline, JoinsRegionsThatMeet) {
  KerfField field(grid);
  open_box(field, Vec2(-5.0, -5.0), Vec2(-1.0, 5.0));
  open_box(field, Vec2(1.0, -5.0), Vec2(5.0, 5.0));
  EXPECT_EQ(outline_of(field).loop_ends.size(), 2U);
  open_box(field, Vec2(-2.0, -0.7), Vec2(2.0, 0.7));
  EXPECT_EQ(outline_of(field).loop_ends.size(), 1U);
}

TEST(RegionOutline, ClosesAtTheGridsBorder) {
  KerfField field(grid);
  open_box(field, Vec2(-40.0, -3.02), Vec2(-7.03, 3.01));
  open_box(field, Vec2(-3.0, -40.0), Vec2(-1.0, 40.0));
  open_box(field, Vec2(11.0, 11.0), Vec2(40.0, 40.0));
  const RegionOutline outline = outline_of(field);
  ASSERT_EQ(outline.loop_ends.size(), 3U);
  for (const Vec2& corner_mm : outline.corners_mm) {
    EXPECT_LT(std::max(std::abs(corner_mm.x), std::abs(corner_mm.y)), 12.0 + spacing_mm);
  }
  // Up to a spacing more on each side that the border cuts.
  const double inside_mm2 = 4.97 * 6.03 + 2.0 * 24.0 + 1.0;
  const double beyond_mm2 = spacing_mm * (6.03 + 2.0 * 2.0 + 2.0 * 1.0 + spacing_mm);
  EXPECT_GT(area_mm2(outline), inside_mm2 - 3.0 * cut_corners_mm2 - 0.06);
  EXPECT_LT(area_mm2(outline), inside_mm2 + beyond_mm2);
}

TEST(RegionOutline, OfASubdividedStraightMotionHasTheSameArea) {
  const Blade blade{.width_mm = 3.0, .depth_mm = 5.0};
  for (const Vec2 way_mm : {Vec2(7.0, 0.0), Vec2(0.0, 6.0), Vec2(5.0, 4.0), Vec2(-4.0, 5.0)}) {
    KerfField whole(grid), parts(grid);
    FieldWindow changed;
    const auto at = [&](int step) {
      const Vec2 tip_mm = Vec2(0.013, -2.0) + (step * 1e-3) * way_mm;
      return pose_at(tip_mm.x, tip_mm.y, 0.4);
    };
    whole.stamp(blade, at(0), at(1000), changed);
    for (int i = 0; i < 1000; ++i) parts.stamp(blade, at(i), at(i + 1), changed);
    const double expected_mm2 = area_mm2(outline_of(whole));
    EXPECT_NEAR(area_mm2(outline_of(parts)), expected_mm2, 1e-6 * expected_mm2);
  }
}

// A side that sweeps about a point leaves a region that bends inwards; a corner's path bends
// outwards. Both keep their
// shape to the slack, with far fewer corners than crossings.
TEST(RegionOutline, SamplesCurvesSparsely) {
  KerfField field(grid);
  FieldWindow changed;
  const Blade blade{.width_mm = 4.0, .depth_mm = 8.0};
  const auto at = [&](int step) {
    const double turn_rad = 0.002 * step;
    return pose_at(0.01 * step, 0.004 * step, turn_rad);
  };
  for (int i = 0; i < 300; ++i) field.stamp(blade, at(i), at(i + 1), changed);
  const RegionOutline outline = outline_of(field);
  ASSERT_EQ(outline.loop_ends.size(), 1U);
  EXPECT_LT(3 * outline.corners_mm.size(), crossings_of(field));
}

TEST(RegionOutline, IsFollowedWithoutAllocation) {
  KerfField field(grid);
  OutlineTracker tracker(grid);
  FieldWindow changed;
  const Blade blade{.width_mm = 5.0, .depth_mm = 8.0};
  const auto feed = [&](int step) {
    const PlanarPose from = pose_at(-8.0 + 0.01 * step, 0.0, 0.3);
    field.stamp(blade, from, pose_at(-8.0 + 0.01 * (step + 1), 0.0, 0.3), changed);
    tracker.update(field);
  };
  feed(0);
  const std::uint64_t before = allocations_of_this_thread();
  for (int i = 1; i < 1000; ++i) feed(i);
  EXPECT_EQ(allocations_of_this_thread(), before);
  EXPECT_EQ(tracker.outline().loop_ends.size(), 1U);
}

}  // namespace
}  // namespace hallux::tests
