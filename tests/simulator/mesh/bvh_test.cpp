#include "simulator/mesh/bvh.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "simulator/base/random.h"
#include "simulator/base/units.h"
#include "simulator/mesh/closest_point.h"
#include "tests/support/worlds.h"

namespace hallux::simulator {
namespace {

using tests::hollow_tube;
using tests::solid_block;

/// A tube turned so that nothing lies along the axes.
IndexedMesh skew_tube() {
  return tests::moved(hollow_tube({.segments = 24, .rings = 6}),
                      {normalised(Quat{0.8, 0.3, -0.4, 0.2}), Vec3{3.0, -2.0, 1.0}});
}

Vec3 any_point(Random& random, double reach_mm) {
  return {random.uniform(-reach_mm, reach_mm), random.uniform(-reach_mm, reach_mm),
          random.uniform(-reach_mm, reach_mm)};
}

double nearest_by_force_mm(const IndexedMesh& mesh, const Vec3& point_mm) {
  double least_mm2 = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const Vec3 apart = closest_on_triangle(corners_of(mesh, i), point_mm).point_mm - point_mm;
    least_mm2 = std::min(least_mm2, glm::dot(apart, apart));
  }
  return std::sqrt(least_mm2);
}

/// The solid angle of the whole surface seen from the point, in whole turns of 4 pi (van Oosterom,
/// Strackee 1983).
double winding(const IndexedMesh& mesh, const Vec3& point_mm) {
  double half_angles_rad = 0.0;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    auto [a, b, c] = corners_of(mesh, i);
    a -= point_mm;
    b -= point_mm;
    c -= point_mm;
    const double la = std::sqrt(glm::dot(a, a));
    const double lb = std::sqrt(glm::dot(b, b));
    const double lc = std::sqrt(glm::dot(c, c));
    half_angles_rad +=
        std::atan2(glm::dot(a, glm::cross(b, c)),
                   la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb);
  }
  return half_angles_rad / (2.0 * pi);
}

TEST(Bvh, NearestIsThatOfAllTriangles) {
  const IndexedMesh mesh = skew_tube();
  const Bvh bvh{mesh};
  Random random{1};
  for (int i = 0; i < 400; ++i) {
    const Vec3 point = any_point(random, 40.0);
    const auto found = bvh.nearest(point);
    ASSERT_TRUE(found);
    ASSERT_NEAR(found->distance_mm, nearest_by_force_mm(mesh, point), 1.0e-12);
    const Vec3 apart = found->point_mm - point;
    ASSERT_NEAR(found->distance_mm, std::sqrt(glm::dot(apart, apart)), 1.0e-12);
    const Vec3 again = closest_on_triangle(corners_of(mesh, found->triangle), point).point_mm;
    ASSERT_EQ(again, found->point_mm);
  }
}

TEST(Bvh, NearestLooksNoFurtherThanAsked) {
  const Bvh bvh{solid_block(Vec3{2.0, 2.0, 2.0})};
  EXPECT_FALSE(bvh.nearest(Vec3{3.0, 0.0, 0.0}, 1.9));
  EXPECT_TRUE(bvh.nearest(Vec3{3.0, 0.0, 0.0}, 2.1));
  EXPECT_EQ(bvh.signed_distance_mm(Vec3{9.0, 0.0, 0.0}, 1.0), 1.0);
  EXPECT_EQ(bvh.signed_distance_mm(Vec3{0.0, 0.0, 0.0}, 0.5), -0.5);
}

TEST(Bvh, SignContainsAndWindingAgree) {
  const IndexedMesh mesh = skew_tube();
  const Bvh bvh{mesh};
  Random random{2};
  int inside = 0;
  for (int i = 0; i < 400; ++i) {
    const Vec3 point = any_point(random, 15.0);
    const bool is_inside = winding(mesh, point) > 0.5;
    inside += is_inside ? 1 : 0;
    ASSERT_EQ(bvh.contains(point), is_inside) << point.x << " " << point.y << " " << point.z;
    ASSERT_EQ(bvh.signed_distance_mm(point) < 0.0, is_inside);
    ASSERT_EQ(bvh.nearest(point)->is_inside, is_inside);
  }
  EXPECT_GT(inside, 50);
}

/// Straight above edges, corners and faces along the axes, where a careless parity counts twice or
/// never.
TEST(Bvh, ContainsHoldsOnTheLinesThroughCornersAndEdges) {
  const Bvh bvh{tests::u_shape(Vec3{30.0, 20.0, 10.0}, 4.0)};
  for (const double x : {-15.0, -13.0, -11.0, 0.0, 11.0, 13.0, 15.0}) {
    for (const double y : {-10.0, -8.0, -6.0, 0.0, 10.0}) {
      EXPECT_FALSE(bvh.contains(Vec3{x, y, 6.0}));
      EXPECT_FALSE(bvh.contains(Vec3{x, y, -6.0}));
    }
  }
  EXPECT_TRUE(bvh.contains(Vec3{0.0, -8.0, 0.0}));
  EXPECT_TRUE(bvh.contains(Vec3{-13.0, -6.0, 0.0}));
  EXPECT_TRUE(bvh.contains(Vec3{13.0, 5.0, 4.9}));
  EXPECT_FALSE(bvh.contains(Vec3{0.0, 5.0, 0.0}));
}

/// Beside corners and edges the nearest face's own normal would often say the wrong side.
TEST(Bvh, SignHoldsBesideCornersAndEdges) {
  const Bvh bvh{tests::u_shape(Vec3{30.0, 20.0, 10.0}, 4.0)};
  Random random{3};
  for (int i = 0; i < 500; ++i) {
    const Vec3 corner{random.uniform() < 0.5 ? 15.0 : -11.0, random.uniform() < 0.5 ? -6.0 : 10.0,
                      random.uniform() < 0.5 ? 5.0 : -5.0};
    const Vec3 point = corner + any_point(random, 0.5);
    ASSERT_EQ(bvh.signed_distance_mm(point) < 0.0, bvh.contains(point));
  }
}

/// A block of 2 mm. A point beside the middle of an edge that two triangles share is put into both:
/// one of the four new triangles is a line, or lies the wrong way round.
IndexedMesh block_with_sliver(double aside_mm) {
  IndexedMesh mesh = solid_block(Vec3{2.0, 2.0, 2.0});
  const Triangle first = mesh.triangles[0];
  const auto [from, to, across] = corners_of(mesh, 0);
  const Vec3 inward = glm::cross(glm::cross(to - from, across - from), to - from);
  const auto middle = static_cast<std::uint32_t>(mesh.points_mm.size());
  mesh.points_mm.push_back(from + 0.5 * (to - from) + aside_mm / length_of(inward) * inward);
  mesh.triangles[0] = {middle, first[1], first[2]};
  mesh.triangles.push_back({first[0], middle, first[2]});
  mesh.triangles.push_back({first[0], first[1], middle});
  return mesh;
}

TEST(Bvh, SignHoldsBesideSlivers) {
  Random random{4};
  for (const double aside_mm : {0.0, 2.0e-7, -2.0e-7}) {
    const IndexedMesh mesh = block_with_sliver(aside_mm);
    const Bvh bvh{mesh};
    for (int i = 0; i < 500; ++i) {
      const Vec3 point = mesh.points_mm.back() + any_point(random, 0.4);
      const auto found = bvh.nearest(point);
      ASSERT_TRUE(found);
      const bool is_inside =
          std::max({std::fabs(point.x), std::fabs(point.y), std::fabs(point.z)}) < 1.0;
      ASSERT_EQ(found->is_inside, is_inside) << aside_mm;
      ASSERT_NEAR(found->distance_mm, nearest_by_force_mm(solid_block(Vec3{2.0, 2.0, 2.0}), point),
                  std::abs(aside_mm) + 1.0e-12);
    }
  }
}

TEST(Bvh, FirstHitIsTheNearestOfAllHits) {
  const Bvh bvh{solid_block(Vec3{2.0, 4.0, 6.0})};
  const auto hit = bvh.first_hit(Vec3{-10.0, 0.0, 0.0}, Vec3{1.0, 0.0, 0.0});
  ASSERT_TRUE(hit);
  EXPECT_DOUBLE_EQ(hit->distance_mm, 9.0);
  EXPECT_FALSE(bvh.first_hit(Vec3{-10.0, 0.0, 0.0}, Vec3{-1.0, 0.0, 0.0}));
  EXPECT_DOUBLE_EQ(bvh.first_hit(Vec3{0.0, 0.0, 0.0}, Vec3{0.0, 0.0, -1.0})->distance_mm, 3.0);
}

TEST(Bvh, NoRayFromInsideEscapes) {
  const IndexedMesh ball = tests::sphere(10.0, 8);
  const Bvh bvh{ball};
  Random random{5};
  for (int i = 0; i < 1000; ++i) {
    // Half of the rays aim exactly at corners and at the middles of edges.
    const std::array<Vec3, 3> corners =
        corners_of(ball, static_cast<std::size_t>(random.bits() % ball.triangles.size()));
    Vec3 aim = i % 2 == 0 ? any_point(random, 1.0) : 0.5 * (corners[0] + corners[i % 3]);
    aim /= std::sqrt(glm::dot(aim, aim));
    const auto hit = bvh.first_hit(Vec3{0.0, 0.0, 0.0}, aim);
    ASSERT_TRUE(hit);
    ASSERT_GT(hit->distance_mm, 9.5);
    ASSERT_LT(hit->distance_mm, 10.0 + 1.0e-12);
  }
}

TEST(Bvh, SlabFindsAllTrianglesThatReachIn) {
  const IndexedMesh mesh = skew_tube();
  const Bvh bvh{mesh};
  Random random{6};
  std::vector<std::uint32_t> found;
  for (int i = 0; i < 100; ++i) {
    Vec3 normal = any_point(random, 1.0);
    normal /= std::sqrt(glm::dot(normal, normal));
    const double offset_mm = random.uniform(-20.0, 20.0);
    const double half_mm = random.uniform(0.0, 1.0);
    bvh.triangles_in_slab(normal, offset_mm, half_mm, found);
    std::vector<std::uint32_t> expected;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
      const auto [a, b, c] = corners_of(mesh, t);
      const auto [low, high] =
          std::minmax({glm::dot(normal, a), glm::dot(normal, b), glm::dot(normal, c)});
      if (low - offset_mm <= half_mm && high - offset_mm >= -half_mm) expected.push_back(t);
    }
    ASSERT_EQ(found, expected);
  }
}

TEST(Bvh, SlabAlongAFaceFindsThatFace) {
  const Bvh bvh{solid_block(Vec3{2.0, 2.0, 2.0})};
  std::vector<std::uint32_t> found{99};
  bvh.triangles_in_slab(Vec3{0.0, 0.0, 1.0}, 1.0, 0.0, found);
  EXPECT_EQ(found.size(), 10U);
  bvh.triangles_in_slab(Vec3{0.0, 0.0, 1.0}, 1.1, 0.05, found);
  EXPECT_TRUE(found.empty());
}

TEST(Bvh, NothingIsNearerThanItsBox) {
  const IndexedMesh mesh = skew_tube();
  const Bvh bvh{mesh};
  Random random{2};
  int outside = 0;
  for (int i = 0; i < 400; ++i) {
    const Vec3 point = any_point(random, 60.0);
    const double outside_mm = bvh.outside_box_mm(point);
    ASSERT_LE(outside_mm, nearest_by_force_mm(mesh, point) + 1.0e-12);
    if (!(outside_mm > 0.0)) continue;
    ++outside;
    ASSERT_FALSE(bvh.contains(point));
  }
  EXPECT_GT(outside, 100);
  EXPECT_EQ(bvh.outside_box_mm(Vec3{3.0, -2.0, 1.0}), 0.0) << "in the middle of the tube";
}

TEST(Bvh, OfNothingFindsNothing) {
  const Bvh bvh{IndexedMesh{}};
  EXPECT_FALSE(bvh.nearest(Vec3{0.0, 0.0, 0.0}));
  EXPECT_FALSE(bvh.contains(Vec3{0.0, 0.0, 0.0}));
  EXPECT_EQ(bvh.outside_box_mm(Vec3{0.0, 0.0, 0.0}), std::numeric_limits<double>::infinity());
  EXPECT_FALSE(bvh.first_hit(Vec3{0.0, 0.0, 0.0}, Vec3{1.0, 0.0, 0.0}));
}

TEST(Bvh, ANanPointIsNowhere) {
  const Bvh bvh{solid_block(Vec3{2.0, 2.0, 2.0})};
  EXPECT_FALSE(bvh.nearest(Vec3{NAN, 0.0, 0.0}));
  EXPECT_FALSE(bvh.contains(Vec3{0.0, NAN, 0.0}));
}

TEST(Bvh, AnswersDoNotDependOnHowItIsBuilt) {
  const IndexedMesh mesh = tests::sphere(10.0, 8);
  const Bvh usual{mesh};
  for (const BvhBuild& build : {BvhBuild{1, 44}, BvhBuild{64, 44}, BvhBuild{4, 0}}) {
    const Bvh other{mesh, build};
    Random random(3, "places");
    for (int i = 0; i < 200; ++i) {
      const Vec3 point_mm(random.uniform(-12.0, 12.0), random.uniform(-12.0, 12.0),
                          random.uniform(-12.0, 12.0));
      ASSERT_EQ(other.signed_distance_mm(point_mm), usual.signed_distance_mm(point_mm));
      std::vector<std::uint32_t> found, expected;
      other.triangles_in_slab(Vec3{0.0, 0.0, 1.0}, point_mm.z, 0.25, found);
      usual.triangles_in_slab(Vec3{0.0, 0.0, 1.0}, point_mm.z, 0.25, expected);
      ASSERT_EQ(found, expected);
    }
  }
}

/// All triangles in one place, or in a row of doubling sizes: trees that no division makes
/// balanced.
TEST(Bvh, BearsMeshesMadeToBeDeep) {
  IndexedMesh heap;
  for (int i = 0; i < 400; ++i) append_mesh(heap, solid_block(Vec3{1.0, 1.0, 1.0}));
  EXPECT_NEAR(Bvh{heap}.nearest(Vec3{2.0, 0.0, 0.0})->distance_mm, 1.5, 1.0e-15);
  IndexedMesh row;
  double size_mm = 1.0e6;
  for (int i = 0; i < 120; ++i, size_mm *= 0.5) {
    append_mesh(row,
                tests::moved(solid_block(Vec3{size_mm * 0.25}), {{}, Vec3{size_mm, 0.0, 0.0}}));
  }
  EXPECT_NEAR(Bvh{row}.nearest(Vec3{-1.0, 0.0, 0.0})->distance_mm, 1.0, 1.0e-12);
}

TEST(Bvh, VisitsBringTheNearestPoint) {
  const Bvh bvh{tests::sphere(10.0, 6)};
  Random random{4};
  int all_visits = 0;
  for (int i = 0; i < 200; ++i) {
    const Vec3 point = any_point(random, 14.0);
    double least_mm = 100.0;
    int visits = 0;
    bvh.visit_near(point, 100.0, [&](const NearTriangle& found) {
      const Vec3 apart = found.closest_mm - point;
      least_mm = std::min(least_mm, std::sqrt(glm::dot(apart, apart)));
      ++visits;
      return least_mm;
    });
    EXPECT_NEAR(least_mm, bvh.nearest(point)->distance_mm, 1.0e-12);
    all_visits += visits;
    visits = 0;
    bvh.visit_near(point, 100.0, [&](const NearTriangle&) {
      ++visits;
      return -1.0;
    });
    EXPECT_LE(visits, 4);
  }
  // Of 432 triangles each, in the middle of the sphere nearly all.
  EXPECT_LT(all_visits, 200 * 60);
}

// Every triangle with a corner within the radius of the line is among those visited, few others.
TEST(Bvh, AlongALineVisitsWhatIsNearIt) {
  const IndexedMesh mesh = tests::sphere(10.0, 12);
  const Bvh bvh{mesh};
  Random random{11};
  for (int i = 0; i < 100; ++i) {
    const Vec3 point = any_point(random, 10.0);
    const Vec3 direction = i < 3 ? Vec3{i == 0, i == 1, i == 2} : unit(any_point(random, 1.0));
    std::vector<bool> is_visited(mesh.triangles.size());
    std::size_t visits = 0;
    bvh.visit_line(point, direction, 1.5,
                   [&](std::uint32_t triangle, const std::array<Vec3, 3>& corner_mm) {
                     EXPECT_EQ(corner_mm, corners_of(mesh, triangle));
                     EXPECT_FALSE(is_visited[triangle]);
                     is_visited[triangle] = true;
                     ++visits;
                   });
    for (std::size_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
      const bool is_near = [&] {
        for (const Vec3& corner : corners_of(mesh, triangle)) {
          const Vec3 arm = corner - point;
          if (length_of(arm - glm::dot(arm, direction) * direction) < 1.5) return true;
        }
        return false;
      }();
      EXPECT_TRUE(is_visited[triangle] || !is_near);
    }
    EXPECT_LT(visits, mesh.triangles.size() / 3);
  }
}

}  // namespace
}  // namespace hallux::simulator
