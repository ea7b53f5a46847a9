#include "simulator/mesh/closest_point.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "simulator/base/random.h"

namespace hallux::simulator {
namespace {

Vec3 any_point(Random& random) {
  return {random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0)};
}

double squared_distance(const Vec3& a, const Vec3& b) { return glm::dot(a - b, a - b); }

RC_GTEST_PROP(ClosestPoint, NoPointOfTheTriangleIsNearer, (std::uint64_t seed)) {
  Random random{seed};
  const std::array<Vec3, 3> corners{any_point(random), any_point(random), any_point(random)};
  const Vec3 point = 2.0 * any_point(random);
  const double found = squared_distance(closest_on_triangle(corners, point).point_mm, point);
  for (int i = 0; i < 50; ++i) {
    const double u = random.uniform();
    const double v = random.uniform(0.0, 1.0 - u);
    const Vec3 other = (1.0 - u - v) * corners[0] + u * corners[1] + v * corners[2];
    RC_ASSERT(found <= squared_distance(other, point) + 1.0e-13);
  }
  RC_ASSERT(found <= squared_distance(closest_on_edges(corners, point).point_mm, point) + 1.0e-13);
}

TEST(ClosestPoint, NamesThePartItLiesOn) {
  const std::array<Vec3, 3> corners{Vec3{0.0, 0.0, 0.0}, Vec3{1.0, 0.0, 0.0}, Vec3{0.0, 1.0, 0.0}};
  EXPECT_EQ(closest_on_triangle(corners, Vec3{0.2, 0.2, 5.0}).part, TrianglePart::Face);
  const ClosestPoint corner = closest_on_triangle(corners, Vec3{2.0, -1.0, 0.0});
  EXPECT_EQ(corner.part, TrianglePart::Corner);
  EXPECT_EQ(corner.index, 1U);
  const ClosestPoint slope = closest_on_triangle(corners, Vec3{1.0, 1.0, 1.0});
  EXPECT_EQ(slope.part, TrianglePart::Edge);
  EXPECT_EQ(slope.index, 1U);
  EXPECT_EQ(closest_on_triangle(corners, Vec3{-1.0, 0.5, 0.0}).index, 2U);
  EXPECT_EQ(closest_on_triangle(corners, Vec3{0.5, -1.0, 0.0}).index, 0U);
}

TEST(ClosestPoint, OfATriangleWithoutAreaIsOnItsEdges) {
  const std::array<Vec3, 3> line{Vec3{0.0, 0.0, 0.0}, Vec3{4.0, 0.0, 0.0}, Vec3{1.0, 0.0, 0.0}};
  EXPECT_EQ(closest_on_edges(line, Vec3{3.0, 2.0, 0.0}).point_mm, (Vec3{3.0, 0.0, 0.0}));
  const std::array<Vec3, 3> spot{Vec3{1.0}, Vec3{1.0}, Vec3{1.0}};
  EXPECT_EQ(closest_on_edges(spot, Vec3{3.0, 2.0, 0.0}).point_mm, Vec3{1.0});
}

}  // namespace
}  // namespace hallux::simulator
