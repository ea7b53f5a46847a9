#include "simulator/cutting/hole/skin_crossings.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "tests/simulator/cutting/worlds/random_worlds.h"
#include "tests/support/worlds.h"

namespace hallux::tests {
namespace {

using namespace simulator;

TEST(SkinCrossings, OfAWireThroughABlockAreTwoCorticesInOrder) {
  const Bvh skin(solid_block({40.0, 20.0, 6.0}));
  const auto crossings = skin_crossings(skin, {1.0, 12.0, 0.5}, {1.0, -15.0, 0.5});
  ASSERT_EQ(crossings.size(), 2U);
  EXPECT_NEAR(crossings[0].way_mm, 2.0, 1e-12);
  EXPECT_TRUE(crossings[0].goes_in);
  EXPECT_NEAR(crossings[1].point_mm.y, -10.0, 1e-12);
  EXPECT_FALSE(crossings[1].goes_in);
}

TEST(SkinCrossings, OfAWireThatEndsInTheBoneAreOneCortex) {
  const Bvh skin(solid_block({40.0, 20.0, 6.0}));
  EXPECT_EQ(skin_crossings(skin, {1.0, 12.0, 0.5}, {1.0, 0.0, 0.5}).size(), 1U);
  EXPECT_EQ(skin_crossings(skin, {1.0, 12.0, 0.5}, {1.0, 11.0, 0.5}).size(), 0U);
  EXPECT_EQ(skin_crossings(skin, {1.0, 1.0, 0.5}, {1.0, -1.0, 0.5}).size(), 0U);
}

// Through the diagonal of two faces, through two corners of the block, and through edges.
TEST(SkinCrossings, ThroughEdgesAndCornersCountOnce) {
  const Bvh skin(solid_block({10.0, 10.0, 10.0}));
  EXPECT_EQ(skin_crossings(skin, {0.0, 0.0, 20.0}, {0.0, 0.0, -20.0}).size(), 2U);
  EXPECT_EQ(skin_crossings(skin, {2.0, 2.0, 20.0}, {2.0, 2.0, -20.0}).size(), 2U);
  EXPECT_EQ(skin_crossings(skin, {-2.0, 2.0, 20.0}, {-2.0, 2.0, -20.0}).size(), 2U);
  EXPECT_EQ(skin_crossings(skin, Vec3(9.0), Vec3(-9.0)).size(), 2U);
  EXPECT_EQ(skin_crossings(skin, {0.0, 9.0, 9.0}, {0.0, -9.0, -9.0}).size(), 2U);
}

TEST(SkinCrossings, OfALineThatOnlyTouchesAnEdgeAreNone) {
  const Bvh skin(solid_block({10.0, 10.0, 10.0}));
  EXPECT_EQ(skin_crossings(skin, {0.0, 10.0, 0.0}, {10.0, 0.0, 0.0}).size(), 0U);
}

TEST(SkinCrossings, OfATubeAreItsOuterSkinAlone) {
  Tube tube;
  tube.inner_radius_mm = 0.0;
  const Bvh skin(hollow_tube(tube));
  EXPECT_EQ(skin_crossings(skin, {0.0, 20.0, 0.1}, {0.0, -20.0, 0.1}).size(), 2U);
  EXPECT_EQ(skin_crossings(skin, {0.0, 20.0, 0.1}, {0.0, -2.0, 0.1}).size(), 1U);
  const Bvh solid(hollow_tube({}));
  EXPECT_EQ(skin_crossings(solid, {0.0, 20.0, 0.1}, {0.0, -20.0, 0.1}).size(), 4U);
}

TEST(InsideIntervals, OfASphereAreItsChord) {
  const double radius_mm = 10.0;
  const Bvh skin(sphere(radius_mm, 40));
  for (const double aside_mm : {0.0, 3.0, 8.0}) {
    const auto inside = inside_intervals(skin, {aside_mm, 0.0, 30.0}, {aside_mm, 0.0, 0.0});
    ASSERT_EQ(inside.size(), 1U);
    const double half_mm = std::sqrt(radius_mm * radius_mm - aside_mm * aside_mm);
    // An edge is at most 0.5 mm long: its middle lies 0.5^2 / 8 R = 3 um deep, seen aslant.
    EXPECT_NEAR(inside[0].from_mm, 30.0 - half_mm, 0.02);
    EXPECT_NEAR(inside[0].to_mm, 30.0 + half_mm, 0.02);
  }
}

TEST(InsideIntervals, OfAUAreItsTwoArms) {
  const Bvh skin(u_shape({12.0, 10.0, 6.0}, 2.0));
  const auto inside = inside_intervals(skin, {-20.0, 4.0, 0.0}, {20.0, 4.0, 0.0});
  ASSERT_EQ(inside.size(), 2U);
  EXPECT_NEAR(inside[0].from_mm, 14.0, 1e-12);
  EXPECT_NEAR(inside[0].to_mm, 16.0, 1e-12);
  EXPECT_NEAR(inside[1].from_mm, 24.0, 1e-12);
  EXPECT_NEAR(inside[1].to_mm, 26.0, 1e-12);
}

// The bone's own parity of a vertical line shares no code with this one.
RC_GTEST_PROP(InsideIntervalsProperty, HoldTheMiddlesThatTheBoneHolds, (std::uint64_t seed)) {
  Random random(seed);
  const Bvh skin(random_bone(random));
  const Vec3 from = 20.0 * random_direction(random), to = 8.0 * random_direction(random);
  const Vec3 way = unit(to - from);
  double last_mm = -1.0e9;
  for (const InsideInterval& inside : inside_intervals(skin, from, to)) {
    RC_ASSERT(inside.from_mm > last_mm);
    RC_ASSERT(inside.to_mm > inside.from_mm);
    const double gap_mm = inside.from_mm - last_mm;
    last_mm = inside.to_mm;
    if (inside.to_mm - inside.from_mm > 1.0e-3)
      RC_ASSERT(skin.contains(from + 0.5 * (inside.from_mm + inside.to_mm) * way));
    if (gap_mm > 1.0e-3 && gap_mm < 1.0e6)
      RC_ASSERT(!skin.contains(from + (inside.from_mm - 0.5 * gap_mm) * way));
    for (const double end_mm : {inside.from_mm, inside.to_mm})
      RC_ASSERT(skin.nearest(from + end_mm * way)->distance_mm < 1.0e-9);
  }
}

// Corners on quarters of a millimetre, lines through them and along edges: all coincides.
RC_GTEST_PROP(InsideIntervalsProperty, OnALatticeNoCrossingIsLostOrDouble, (std::uint64_t seed)) {
  Random random(seed);
  const IndexedMesh mesh = lattice_bone(random);
  const Bvh skin(mesh);
  const Vec3 through = mesh.points_mm[random.bits() % mesh.points_mm.size()];
  Vec3 other = mesh.points_mm[random.bits() % mesh.points_mm.size()];
  if (other == through) other = through + Vec3{1.0, 0.0, 0.0};
  const Vec3 way = unit(other - through);
  const Vec3 from = through - 20.0 * way;
  for (const InsideInterval& inside : inside_intervals(skin, from, through)) {
    const Vec3 middle = from + 0.5 * (inside.from_mm + inside.to_mm) * way;
    // In the solid or, along an edge or a face, on it.
    RC_ASSERT(skin.contains(middle) || skin.nearest(middle)->distance_mm < 1.0e-9);
    RC_ASSERT(inside.from_mm > 0.0 && inside.to_mm < 40.0);
  }
}

}  // namespace
}  // namespace hallux::tests
