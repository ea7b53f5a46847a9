#include "simulator/cutting/fill/triangulate.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <map>
#include <utility>

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
};

/// A star-shaped loop; `sign` -1 runs clockwise.
std::vector<LatticePoint> star(Random& random, std::size_t count, double radius, double roughness,
                               double sign, const LatticePoint& middle = {}) {
  std::vector<LatticePoint> corners;
  for (std::size_t i = 0; i < count; ++i) {
    const double angle =
        sign * 2.0 * 3.14159265358979323846 * static_cast<double>(i) / static_cast<double>(count);
    const double reach = radius * (1.0 + roughness * random.uniform(-1.0, 1.0));
    corners.push_back({middle.u + static_cast<std::int64_t>(reach * std::cos(angle)),
                       middle.v + static_cast<std::int64_t>(reach * std::sin(angle))});
  }
  return corners;
}

/// Loop edges used once; all others once each way; the areas add up, and where `is_simple` none is
/// negative.
void expect_filled(const Figure& figure, bool is_simple) {
  const std::vector<Triangle> triangles = triangulate(figure.points, figure.loops);
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> balance;
  std::int64_t area = 0, wanted = 0;
  for (const Triangle& corners : triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      ++balance[{corners[i], corners[(i + 1) % 3]}];
      --balance[{corners[(i + 1) % 3], corners[i]}];
    }
    const std::int64_t own =
        turn(figure.points[corners[0]], figure.points[corners[1]], figure.points[corners[2]]);
    if (is_simple) {
      EXPECT_GE(own, 0);
    }
    area += own;
  }
  for (const Loop& loop : figure.loops) {
    wanted += doubled_area(figure.points, loop);
    if (loop.size() < 3) continue;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      --balance[{loop[i], loop[(i + 1) % loop.size()]}];
      ++balance[{loop[(i + 1) % loop.size()], loop[i]}];
    }
  }
  for (const auto& [edge, count] : balance) EXPECT_EQ(count, 0);
  EXPECT_EQ(area, wanted);
}

TEST(Triangulate, ARoughRingWithHolesIsFilledWithoutOverlap) {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    Random random(seed);
    Figure figure;
    figure.add(star(random, 60 + 5 * seed, 6.0e7, 0.1, 1.0));
    figure.add(star(random, 40, 1.0e7, 0.4, -1.0));
    figure.add(star(random, 17, 5.0e6, 0.4, -1.0, {30000000, 100}));
    figure.add(star(random, 9, 5.0e6, 0.2, -1.0, {-100, -30000000}));
    figure.add(star(random, 21, 4.0e6, 0.2, 1.0, {0, 0}));  // an island in the first hole
    expect_filled(figure, true);
  }
}

TEST(Triangulate, CollinearAndCoincidentCornersClose) {
  Figure figure;
  figure.add(
      {{0, 0}, {5, 0}, {10, 0}, {10, 0}, {10, 5}, {10, 10}, {5, 10}, {0, 10}, {0, 10}, {0, 5}});
  figure.add({{2, 2}, {2, 8}, {5, 8}, {8, 8}, {8, 2}, {5, 2}});
  expect_filled(figure, true);
}

TEST(Triangulate, LoopsWithoutAreaClose) {
  Figure figure;
  figure.add({{0, 0}, {4, 0}, {9, 0}, {4, 0}});
  figure.add({{20, 0}, {20, 0}, {20, 0}});
  figure.add({{30, 0}, {40, 0}});
  figure.add({{50, 0}, {52, 2}, {54, 4}, {53, 3}, {51, 1}});
  expect_filled(figure, true);
}

TEST(Triangulate, HolesThatTouchCornersAndEdgesClose) {
  Figure figure;
  figure.add({{0, 0}, {100, 0}, {100, 100}, {0, 100}});
  figure.add({{0, 0}, {20, 40}, {40, 20}});     // touches a corner
  figure.add({{100, 50}, {80, 40}, {80, 60}});  // touches an edge
  figure.add({{60, 60}, {50, 70}, {60, 80}});
  figure.add({{60, 60}, {70, 80}, {70, 50}});  // touches another hole
  expect_filled(figure, false);
}

/// The furthest that a triangle of the figure faces the wrong way: twice its area over its longest
/// side, in steps.
std::int64_t deepest_fold(const Figure& figure) {
  std::int64_t deepest = 0;
  for (const Triangle& corners : triangulate(figure.points, figure.loops)) {
    const LatticePoint &a = figure.points[corners[0]], &b = figure.points[corners[1]],
                       &c = figure.points[corners[2]];
    const std::int64_t longest =
        std::max({std::abs(a.u - b.u), std::abs(a.v - b.v), std::abs(b.u - c.u),
                  std::abs(b.v - c.v), std::abs(c.u - a.u), std::abs(c.v - a.v), std::int64_t{1}});
    deepest = std::max(deepest, -turn(a, b, c) / longest);
  }
  return deepest;
}

TEST(Triangulate, ALoopAndTheSameLoopBackFoldNothing) {
  Figure figure;
  figure.add({{1572864, -2097152},
              {1572864, -2097152},
              {-1048576, -2097152},
              {-1048576, -1398101},
              {-1048576, -1398101},
              {-1048576, -2097152}});
  expect_filled(figure, true);
}

TEST(Triangulate, AWayThereAndBackWithinTheRoundingFoldsNothing) {
  Figure figure;  // from (271391, 262144) the ring comes back two steps beside the way it went
  figure.add({{1098874, -262144},
              {524288, 101910},
              {524288, 83319},
              {271391, 262144},
              {271391, 262144},
              {1012847, -262144}});
  expect_filled(figure, false);
  EXPECT_LE(deepest_fold(figure), 2);
}

TEST(Triangulate, ACornerRoundedThroughAnEdgeItTouchesFoldsNothing) {
  // (-114020, 262144) touches the edge between the first two corners, a tenth of a step beyond it
  Figure figure;
  figure.add({{-262144, 240414},
              {28200, 283008},
              {210394, 371882},
              {-149196, 271838},
              {-114020, 262144},
              {-202454, 257021}});
  expect_filled(figure, false);
  EXPECT_LE(deepest_fold(figure), 2);
}

TEST(Triangulate, LoopsThatCrossThemselvesKeepTheirSignedArea) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    Random random(seed);
    Figure figure;
    std::vector<LatticePoint> corners(25);
    for (LatticePoint& corner : corners) {
      corner.u = static_cast<std::int64_t>(random.uniform(-20.0, 20.0));
      corner.v = static_cast<std::int64_t>(random.uniform(-20.0, 20.0));
    }
    figure.add(corners);
    expect_filled(figure, false);
  }
}

TEST(Triangulate, ThreeThousandCornersTakeFarLessThanATenthOfASecond) {
  Random random(3);
  Figure figure;
  figure.add(star(random, 2000, 6.0e7, 0.02, 1.0));
  figure.add(star(random, 1000, 3.0e7, 0.02, -1.0));
  const auto start = std::chrono::steady_clock::now();
  expect_filled(figure, true);
  const std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - start;
  RecordProperty("milliseconds", std::to_string(taken.count()));
  EXPECT_LT(taken.count(), 1000.0);  // hangs are what is looked for: the machine may be busy
}

}  // namespace
}  // namespace hallux::tests
