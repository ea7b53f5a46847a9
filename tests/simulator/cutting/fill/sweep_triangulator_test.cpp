#include "simulator/cutting/fill/sweep_triangulator.h"

#include <gtest/gtest.h>

#include <cmath>

#include "simulator/base/random.h"

namespace hallux::tests {
namespace {

using namespace simulator;

struct Figure {
  std::vector<LatticePoint> points;
  std::vector<Loop> loops;

  void add(const std::vector<LatticePoint>& corners) {
    Loop& loop = loops.emplace_back();
    for (const LatticePoint& corner : corners) {
      loop.push_back(static_cast<std::uint32_t>(points.size()));
      points.push_back(corner);
    }
  }
  bool fill(std::vector<Triangle>& triangles) const {
    SweepTriangulator sweep;
    sweep.begin(points);
    for (const Loop& loop : loops) sweep.add_loop(loop);
    return sweep.fill(triangles);
  }
};

void expect_filled(const Figure& figure, std::size_t holes) {
  std::vector<Triangle> triangles;
  ASSERT_TRUE(figure.fill(triangles));
  EXPECT_EQ(triangles.size(), figure.points.size() - 2 * (figure.loops.size() - holes) + 2 * holes);
  std::int64_t area = 0, wanted = 0;
  for (const Triangle& corners : triangles) {
    const std::int64_t own =
        turn(figure.points[corners[0]], figure.points[corners[1]], figure.points[corners[2]]);
    EXPECT_GE(own, 0);
    area += own;
  }
  for (const Loop& loop : figure.loops) wanted += doubled_area(figure.points, loop);
  EXPECT_EQ(area, wanted);
}

/// Wanders between two radii; `sign` -1 runs clockwise.
std::vector<LatticePoint> star(Random& random, std::size_t count, double least, double most,
                               double sign) {
  std::vector<LatticePoint> corners;
  for (std::size_t i = 0; i < count; ++i) {
    const double angle_rad =
        sign * 6.283185307179586 * static_cast<double>(i) / static_cast<double>(count);
    const double reach = random.uniform(least, most);
    corners.push_back({static_cast<std::int64_t>(reach * std::cos(angle_rad)),
                       static_cast<std::int64_t>(reach * std::sin(angle_rad))});
  }
  return corners;
}

TEST(SweepTriangulator, ASquareIsTwoTriangles) {
  Figure figure;
  figure.add({{0, 0}, {9, 0}, {9, 9}, {0, 9}});
  expect_filled(figure, 0);
}

TEST(SweepTriangulator, CornersInLineAreKept) {
  Figure figure;
  figure.add({{0, 0}, {5, 0}, {9, 0}, {9, 4}, {9, 9}, {3, 9}, {0, 9}, {0, 7}, {0, 2}});
  figure.add({{2, 2}, {2, 6}, {2, 7}, {6, 7}, {6, 2}, {4, 2}});
  expect_filled(figure, 1);
}

TEST(SweepTriangulator, TeethOnBothSidesPartAndJoinTheGap) {
  Figure figure;
  figure.add({{0, 0}, {40, 10}, {35, 12}, {60, 0}, {62, 30}, {20, 22}, {25, 20}, {1, 30}});
  expect_filled(figure, 0);
}

TEST(SweepTriangulator, RoughRingsWithinRoughRingsAreFilled) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    Random random(seed);
    Figure figure;
    figure.add(star(random, 20 + 4 * seed, 4.0e7, 6.0e7, 1.0));
    figure.add(star(random, 10 + seed, 2.0e7, 3.0e7, -1.0));
    figure.add(star(random, 7 + seed, 0.5e7, 1.5e7, 1.0));
    expect_filled(figure, 1);
  }
}

TEST(SweepTriangulator, WhatCrossesItselfIsRefusedAndNothingIsAdded) {
  for (const std::vector<LatticePoint>& crossing :
       {std::vector<LatticePoint>{{0, 0}, {10, 10}, {10, 0}, {0, 10}},
        std::vector<LatticePoint>{{0, 0}, {0, 10}, {10, 10}, {10, 0}},  // inside out
        std::vector<LatticePoint>{{0, 0}, {10, 0}, {5, 5}, {6, -1}, {8, 9}, {0, 4}}}) {
    Figure figure;
    figure.add(crossing);
    std::vector<Triangle> triangles{{7, 8, 9}};
    EXPECT_FALSE(figure.fill(triangles));
    EXPECT_EQ(triangles.size(), 1u);
  }
}

TEST(SweepTriangulator, ASpikeIsRefused) {
  Figure figure;
  figure.add({{0, 0}, {10, 0}, {10, 10}, {5, 5}, {-9, 5}, {5, 5}});
  std::vector<Triangle> triangles;
  EXPECT_FALSE(figure.fill(triangles));
}

}  // namespace
}  // namespace hallux::tests
