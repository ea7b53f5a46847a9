#include "simulator/cutting/hole/implant_tip.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "tests/support/worlds.h"

namespace hallux::tests {
namespace {

using namespace simulator;

TEST(Protrusion, IsTheWayOfTheTipBeyondTheFarSkin) {
  const Bvh skin(solid_block({40.0, 20.0, 6.0}));
  EXPECT_NEAR(*protrusion_mm(skin, {1.0, 15.0, 0.2}, {1.0, -11.5, 0.2}), 1.5, 1e-12);
  EXPECT_NEAR(*protrusion_mm(skin, {1.0, 15.0, 0.2}, {1.0, -10.0, 0.2}), 0.0, 1e-12);
}

TEST(Protrusion, OfATipWithinTheBoneIsTheWayLeft) {
  const Bvh skin(solid_block({40.0, 20.0, 6.0}));
  EXPECT_NEAR(*protrusion_mm(skin, {1.0, 15.0, 0.2}, {1.0, 4.0, 0.2}), -14.0, 1e-12);
  // Aslant: along the axis, not straight to the skin.
  EXPECT_NEAR(*protrusion_mm(skin, {0.0, 15.0, 0.0}, {10.0, 5.0, 0.0}), -10.0 * std::sqrt(2.0),
              1e-9);
}

TEST(Protrusion, IsNothingWhereTheImplantStaysBesideTheBone) {
  const Bvh skin(solid_block({40.0, 20.0, 6.0}));
  EXPECT_FALSE(protrusion_mm(skin, {1.0, 15.0, 0.2}, {1.0, 11.0, 0.2}).has_value());
  EXPECT_FALSE(protrusion_mm(skin, {30.0, 15.0, 0.2}, {30.0, -15.0, 0.2}).has_value());
  // All of it beyond the bone.
  EXPECT_FALSE(protrusion_mm(skin, {1.0, -11.0, 0.2}, {1.0, -15.0, 0.2}).has_value());
}

TEST(Protrusion, OfTwoArmsCountsFromTheLastOneReached) {
  const Bvh skin(u_shape({12.0, 10.0, 6.0}, 2.0));
  EXPECT_NEAR(*protrusion_mm(skin, {-20.0, 4.0, 0.0}, {1.0, 4.0, 0.0}), 5.0, 1e-12);
  EXPECT_NEAR(*protrusion_mm(skin, {-20.0, 4.0, 0.0}, {7.0, 4.0, 0.0}), 1.0, 1e-12);
}

TEST(TipClearance, IsTheLeastDistanceToTheJointSurface) {
  IndexedMesh joint;
  joint.points_mm = {{0.0, 0.0, 0.0}, {10.0, 0.0, 0.0}, {0.0, 10.0, 0.0}, {0.0, 0.0, 50.0}};
  joint.triangles = {{0, 1, 2}, {0, 1, 3}};
  const std::array<std::uint32_t, 1> first{0}, second{1};
  EXPECT_NEAR(*tip_clearance_mm({2.0, 2.0, -3.0}, joint, first), 3.0, 1e-12);
  EXPECT_NEAR(*tip_clearance_mm({2.0, 4.0, 10.0}, joint, second), 4.0, 1e-12);
  EXPECT_NEAR(*tip_clearance_mm({-3.0, -4.0, 0.0}, joint, first), 5.0, 1e-12);
  EXPECT_FALSE(tip_clearance_mm({0.0, 0.0, 0.0}, joint, {}).has_value());
}

}  // namespace
}  // namespace hallux::tests
