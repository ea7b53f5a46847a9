#include "simulator/cutting/field/kerf.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "simulator/base/random.h"

namespace hallux::tests {
namespace {

using namespace simulator;

const FieldGrid grid{.origin_mm = Vec2(-30.0), .spacing_mm = 0.1, .u_count = 601, .v_count = 601};

std::vector<float> values_of(const KerfField& field) {
  std::vector<float> values;
  for (std::int32_t v = 0; v < field.grid().v_count; ++v) {
    for (std::int32_t u = 0; u < field.grid().u_count; ++u) values.push_back(field.at(u, v));
  }
  return values;
}

PlanarPose pose_at(double u_mm, double v_mm, double turn) {
  const double length = std::sqrt(1.0 + turn * turn);
  return {Vec2(u_mm, v_mm), Vec2(1.0 / length, turn / length)};
}

TEST(Kerf, HeldStillOpensNoMoreThanItsOwnFootprint) {
  KerfField field(grid);
  FieldWindow changed;
  const PlanarPose pose{Vec2(5.03, 0.02)};
  field.stamp({.width_mm = 10.0, .depth_mm = 20.0}, pose, pose, changed);
  for (std::int32_t v = 0; v < grid.v_count; ++v) {
    for (std::int32_t u = 0; u < grid.u_count; ++u) {
      const double x_mm = -30.0 + 0.1 * u - 5.03, y_mm = -30.0 + 0.1 * v - 0.02;
      const double inside_mm = std::min({-x_mm, x_mm + 20.0, y_mm + 5.0, 5.0 - y_mm});
      const double expected_mm = std::clamp(inside_mm, -0.1, 0.1);
      ASSERT_NEAR(static_cast<double>(field.at(u, v)), expected_mm, 1e-6);
    }
  }
  // Between nodes the border is where the rectangle's is.
  EXPECT_TRUE(field.is_open(Vec2(5.02, 0.0)));
  EXPECT_FALSE(field.is_open(Vec2(5.04, 0.0)));
  EXPECT_FALSE(field.is_open(Vec2(50.0, 0.0)));
}

TEST(Kerf, ChangedIsTheSmallestWindowOfWhatRose) {
  KerfField field(grid);
  FieldWindow changed;
  const Blade blade{.width_mm = 4.0, .depth_mm = 6.0};
  field.stamp(blade, {Vec2(0.0)}, {Vec2(0.0)}, changed);
  const std::vector<float> before = values_of(field);
  field.stamp(blade, {Vec2(0.0)}, {Vec2(0.35, 0.0)}, changed);
  const std::vector<float> after = values_of(field);
  FieldWindow expected{grid.u_count, grid.v_count, 0, 0};
  for (std::int32_t v = 0; v < grid.v_count; ++v) {
    for (std::int32_t u = 0; u < grid.u_count; ++u) {
      const auto node = static_cast<std::size_t>(v) * static_cast<std::size_t>(grid.u_count) +
                        static_cast<std::size_t>(u);
      ASSERT_GE(after[node], before[node]);
      if (after[node] == before[node]) continue;
      expected = {std::min(expected.u_first, u), std::min(expected.v_first, v),
                  std::max(expected.u_last, u + 1), std::max(expected.v_last, v + 1)};
    }
  }
  EXPECT_EQ(changed.u_first, expected.u_first);
  EXPECT_EQ(changed.v_first, expected.v_first);
  EXPECT_EQ(changed.u_last, expected.u_last);
  EXPECT_EQ(changed.v_last, expected.v_last);
  field.stamp(blade, {Vec2(0.0)}, {Vec2(0.35, 0.0)}, changed);
  EXPECT_TRUE(changed.is_empty());
}

TEST(Kerf, OrderAndRepetitionDoNotMatterToTheLastBit) {
  Random random(7);
  std::vector<std::pair<PlanarPose, PlanarPose>> stamps;
  for (int i = 0; i < 40; ++i) {
    const double u_mm = random.uniform(-8.0, 12.0), v_mm = random.uniform(-6.0, 6.0);
    stamps.emplace_back(pose_at(u_mm, v_mm, random.uniform(-0.5, 0.5)),
                        pose_at(u_mm + random.uniform(-1.0, 1.0), v_mm + random.uniform(-1.0, 1.0),
                                random.uniform(-0.5, 0.5)));
  }
  const Blade blade{.width_mm = 7.0, .depth_mm = 9.0};
  FieldWindow changed;
  KerfField forward(grid), backward(grid);
  for (const auto& [from, to] : stamps) forward.stamp(blade, from, to, changed);
  for (std::size_t i = stamps.size(); i-- > 0;) {
    backward.stamp(blade, stamps[i].first, stamps[i].second, changed);
    backward.stamp(blade, stamps[i / 2].first, stamps[i / 2].second, changed);
  }
  EXPECT_EQ(values_of(forward), values_of(backward));
}

// What a stamp passes over because earlier ones cover it must be what could not rise: the field is
// the greatest of the stamps alone, bit for bit. A trembling saw that feeds, turns, and comes again
// elsewhere on the same lines.
TEST(Kerf, IsTheGreatestOfItsStampsAloneToTheLastBit) {
  Random random(11);
  const Blade blade{.width_mm = 5.0, .depth_mm = 8.0};
  FieldWindow changed;
  KerfField together(grid);
  std::vector<float> greatest_mm = values_of(together);
  for (const double turn : {0.0, 1e-9, 0.3, -2.0}) {
    PlanarPose from = pose_at(0.0, 0.0, turn);
    for (int i = 0; i < 25; ++i) {
      const double way_mm = 0.05 * i + (i > 15 ? 9.0 : 0.0);
      const double tremor_mm = turn == 0.0 ? 0.0 : random.uniform(-0.02, 0.02);
      const PlanarPose to = pose_at(way_mm, turn * way_mm + tremor_mm, turn + 0.1 * tremor_mm);
      together.stamp(blade, from, to, changed);
      KerfField alone(grid);
      alone.stamp(blade, from, to, changed);
      const std::vector<float> values_mm = values_of(alone);
      for (std::size_t k = 0; k < greatest_mm.size(); ++k) {
        greatest_mm[k] = std::max(greatest_mm[k], values_mm[k]);
      }
      from = to;
    }
  }
  EXPECT_TRUE(values_of(together) == greatest_mm);
}

// In every direction to the blade: a corner leaves a trace that no single pose shows.
TEST(Kerf, ASubdividedStraightMotionRaisesTheFieldAsTheWholeDoes) {
  const Blade blade{.width_mm = 10.0, .depth_mm = 12.0};
  FieldWindow changed;
  for (const Vec2 way_mm : {Vec2(9.0, 0.0), Vec2(0.0, 7.0), Vec2(6.0, 5.0), Vec2(-3.0, 8.0)}) {
    KerfField whole(grid), parts(grid);
    const int count = 100;
    const auto at = [&](int step) {
      const Vec2 tip_mm = Vec2(0.03, 0.3) + (static_cast<double>(step) / count) * way_mm;
      return pose_at(tip_mm.x, tip_mm.y, 0.1);
    };
    whole.stamp(blade, at(0), at(count), changed);
    for (int i = 0; i < count; ++i) parts.stamp(blade, at(i), at(i + 1), changed);
    const std::vector<float> expected_mm = values_of(whole), values_mm = values_of(parts);
    for (std::size_t k = 0; k < values_mm.size(); ++k) {
      // Far outside both are the limit; the value of a part is never more than the whole's, but for
      // rounding.
      ASSERT_NEAR(values_mm[k], expected_mm[k], 2e-8F) << "way " << way_mm.x << ' ' << way_mm.y;
    }
  }
}

TEST(Kerf, AHullOfTwoTurnedBladesHoldsBoth) {
  const Blade blade{.width_mm = 8.0, .depth_mm = 10.0};
  FieldWindow changed;
  KerfField both(grid), one(grid);
  both.stamp(blade, pose_at(0.0, 0.0, 0.0), pose_at(3.0, 1.0, 0.3), changed);
  one.stamp(blade, pose_at(0.0, 0.0, 0.0), pose_at(0.0, 0.0, 0.0), changed);
  one.stamp(blade, pose_at(3.0, 1.0, 0.3), pose_at(3.0, 1.0, 0.3), changed);
  const std::vector<float> hull = values_of(both), ends = values_of(one);
  for (std::size_t i = 0; i < hull.size(); ++i) {
    if (ends[i] > 0.0F) {
      ASSERT_GE(hull[i], ends[i] - 1e-6F);
    }
  }
}

TEST(Kerf, WhatIsNotFiniteOrOutsideOpensNothing) {
  KerfField field(grid);
  FieldWindow changed;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  field.stamp({}, {Vec2(nan, 0.0)}, {Vec2(0.0)}, changed);
  EXPECT_TRUE(changed.is_empty());
  field.stamp({}, {Vec2(0.0)}, {Vec2(0.0), Vec2(nan, 1.0)}, changed);
  EXPECT_TRUE(changed.is_empty());
  field.stamp({}, {Vec2(500.0, 0.0)}, {Vec2(1e9, 0.0)}, changed);
  EXPECT_TRUE(changed.is_empty());
  field.stamp({}, {Vec2(-500.0, -1e12)}, {Vec2(-500.0, -1e12)}, changed);
  EXPECT_TRUE(changed.is_empty());
}

TEST(Kerf, APoseIsProjectedToItsPlane) {
  const RigidTransform bone_from_kerf{rotation_about(Vec3(0.0, 0.0, 1.0), 0.5),
                                      Vec3(1.0, 2.0, 3.0)};
  const RigidTransform kerf_from_tool{rotation_about(Vec3(0.0, 0.0, 1.0), 0.25),
                                      Vec3(4.0, -2.0, 0.05)};
  const PlanarPose pose = planar_pose({bone_from_kerf, 0.5}, bone_from_kerf * kerf_from_tool);
  EXPECT_NEAR(pose.tip_mm.x, 4.0, 1e-12);
  EXPECT_NEAR(pose.tip_mm.y, -2.0, 1e-12);
  EXPECT_NEAR(pose.direction.x, std::cos(0.25), 1e-12);
  EXPECT_NEAR(pose.direction.y, std::sin(0.25), 1e-12);
}

}  // namespace
}  // namespace hallux::tests
