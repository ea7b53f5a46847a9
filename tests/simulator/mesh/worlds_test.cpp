#include "tests/support/worlds.h"

#include <gtest/gtest.h>

#include <cmath>

#include "simulator/base/units.h"
#include "simulator/mesh/read_mesh.h"

/// The worlds that other tests stand on must themselves be what they say.
namespace hallux::tests {
namespace {

using simulator::check_closed_solid;
using simulator::signed_volume_mm3;

TEST(Worlds, ABlockHasItsVolume) {
  const auto block = solid_block(Vec3{10.0, 20.0, 30.0});
  check_closed_solid(block, "block");
  EXPECT_EQ(block.triangles.size(), 12U);
  EXPECT_NEAR(signed_volume_mm3(block), 6000.0, 1.0e-9);
}

TEST(Worlds, TwoBlocksAreApart) {
  const auto blocks = two_blocks(Vec3{10.0, 20.0, 30.0}, 2.0);
  check_closed_solid(blocks, "blocks");
  EXPECT_EQ(blocks.triangles.size(), 24U);
  EXPECT_NEAR(signed_volume_mm3(blocks), 12000.0, 1.0e-9);
}

TEST(Worlds, AUHasTwoArmsAndAFloor) {
  const auto u = u_shape(Vec3{30.0, 20.0, 10.0}, 4.0);
  check_closed_solid(u, "u");
  EXPECT_NEAR(signed_volume_mm3(u), (30.0 * 4.0 + 2.0 * 4.0 * 16.0) * 10.0, 1.0e-9);
}

TEST(Worlds, ATubeIsAPrismLessItsCanal) {
  const auto tube = hollow_tube({});
  check_closed_solid(tube, "tube");
  const double segment_area = 32.0 * std::sin(2.0 * pi / 64.0);
  EXPECT_NEAR(signed_volume_mm3(tube), segment_area * (64.0 * 60.0 - 25.0 * 52.0), 1.0e-9);
  check_closed_solid(hollow_tube({.inner_radius_mm = 0.0, .segments = 7, .rings = 3}), "rod");
}

TEST(Worlds, ASphereIsInscribedInItsRadius) {
  const auto ball = sphere(10.0, 12);
  check_closed_solid(ball, "sphere");
  EXPECT_EQ(ball.triangles.size(), 12U * 144U);
  EXPECT_EQ(ball.points_mm.size(), 6U * 144U + 2U);
  const double full = 4.0 / 3.0 * pi * 1000.0;
  EXPECT_LT(signed_volume_mm3(ball), full);
  EXPECT_GT(signed_volume_mm3(ball), 0.98 * full);
}

TEST(Worlds, ADenseSphereHasEnoughTriangles) {
  EXPECT_GE(dense_sphere(10.0, 5000).triangles.size(), 5000U);
  EXPECT_LT(dense_sphere(10.0, 5000).triangles.size(), 5600U);
}

TEST(Worlds, InsideOutHasTheOppositeVolume) {
  const auto block = solid_block(Vec3{1.0, 2.0, 3.0});
  EXPECT_NEAR(signed_volume_mm3(inside_out(block)), -6.0, 1.0e-12);
}

}  // namespace
}  // namespace hallux::tests
