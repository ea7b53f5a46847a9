#include "simulator/cutting/hole/axis_clearance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "simulator/base/random.h"
#include "simulator/mesh/closest_point.h"

namespace hallux::tests {
namespace {

using namespace simulator;

/// Two triangles that stand on each other at one edge.
IndexedMesh corner_of_joint() {
  IndexedMesh joint;
  joint.points_mm = {{0.0, 0.0, 0.0}, {10.0, 0.0, 0.0}, {0.0, 10.0, 0.0}, {0.0, 0.0, 50.0}};
  joint.triangles = {{0, 1, 2}, {0, 1, 3}};
  return joint;
}

constexpr std::array<std::uint32_t, 1> flat{0}, upright{1};

TEST(AxisClearance, OfATipAheadOfTheSurfaceIsItsDistance) {
  const IndexedMesh joint = corner_of_joint();
  EXPECT_NEAR(*axis_clearance_mm({{2.0, 2.0, -20.0}, {2.0, 2.0, -3.0}}, joint, flat), 3.0, 1e-12);
  EXPECT_NEAR(*axis_clearance_mm({{2.0, 9.0, 10.0}, {2.0, 4.0, 10.0}}, joint, upright), 4.0, 1e-12);
  EXPECT_NEAR(*axis_clearance_mm({{-9.0, -12.0, 0.0}, {-3.0, -4.0, 0.0}}, joint, flat), 5.0, 1e-12);
}

TEST(AxisClearance, IsNothingLeftWhereTheAxisWentThrough) {
  const IndexedMesh joint = corner_of_joint();
  EXPECT_EQ(*axis_clearance_mm({{2.0, 2.0, -20.0}, {2.0, 2.0, 15.0}}, joint, flat), 0.0);
  EXPECT_NEAR(*axis_clearance_mm({{12.0, 2.0, -20.0}, {12.0, 2.0, 15.0}}, joint, flat),
              std::sqrt(8.0), 1e-12)
      << "past it";
}

TEST(AxisClearance, IsThatOfTheNearestPointOfTheAxis) {
  const IndexedMesh joint = corner_of_joint();
  // Along the flat one, and nearest to it between its ends.
  EXPECT_NEAR(*axis_clearance_mm({{-5.0, 3.0, -2.0}, {15.0, 3.0, -2.0}}, joint, flat), 2.0, 1e-12);
  EXPECT_NEAR(*axis_clearance_mm({{-6.0, 0.0, -4.0}, {0.0, -6.0, -4.0}}, joint, flat),
              std::sqrt(18.0 + 16.0), 1e-12);
  EXPECT_FALSE(axis_clearance_mm({{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}}, joint, {}).has_value());
}

TEST(AxisClearance, OfRandomAxesIsThatOfTheirPoints) {
  Random random(7);
  const auto point = [&] {
    return Vec3{random.uniform(-15.0, 15.0), random.uniform(-15.0, 15.0),
                random.uniform(-15.0, 15.0)};
  };
  const IndexedMesh joint = corner_of_joint();
  for (int run = 0; run < 200; ++run) {
    const Segment axis{point(), point()};
    double least_mm = std::numeric_limits<double>::infinity();
    constexpr int samples = 2000;
    for (int i = 0; i <= samples; ++i) {
      const Vec3 point_mm = axis.from + (static_cast<double>(i) / samples) * (axis.to - axis.from);
      const Vec3 closest_mm = closest_on_triangle(corners_of(joint, 0), point_mm).point_mm;
      least_mm = std::min(least_mm, length_of(point_mm - closest_mm));
    }
    const double step_mm = length_of(axis.to - axis.from) / samples;
    EXPECT_NEAR(*axis_clearance_mm(axis, joint, flat), least_mm, step_mm) << run;
  }
}

}  // namespace
}  // namespace hallux::tests
