#include "simulator/cutting/hole/hole_rim.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "simulator/base/units.h"
#include "simulator/cutting/hole/skin_along_axis.h"
#include "tests/simulator/cutting/worlds/random_worlds.h"
#include "tests/support/worlds.h"

namespace hallux::tests {
namespace {

using namespace simulator;

std::vector<HoleRim> rims_of(const IndexedMesh& mesh, const Capsule& hole) {
  return hole_rims(mesh, Bvh(mesh), hole);
}

double away_from_axis_mm(const Capsule& hole, const Vec3& point_mm) {
  const Vec3 local = frame_along(hole.from_in_body_mm, hole.to_in_body_mm).to_local(point_mm);
  return std::sqrt(local.x * local.x + local.y * local.y);
}

double length_around_mm(const HoleRim& rim) {
  double length_mm = 0.0;
  for (std::size_t i = 0; i < rim.points_mm.size(); ++i)
    length_mm += length_of(rim.points_mm[(i + 1) % rim.points_mm.size()] - rim.points_mm[i]);
  return length_mm;
}

TEST(HoleRim, OfAHoleInAFaceIsACircleOnIt) {
  const Capsule hole{{3.0, 12.0, 0.7}, {3.0, 5.0, 0.7}, 0.8};
  const auto rims = rims_of(solid_block({40.0, 20.0, 6.0}), hole);
  ASSERT_EQ(rims.size(), 1U);
  EXPECT_GE(rims[0].points_mm.size(), 48U);
  EXPECT_NEAR(rims[0].way_mm, 2.0, 1e-12);
  for (const Vec3& point : rims[0].points_mm) {
    EXPECT_NEAR(point.y, 10.0, 1e-12);
    EXPECT_NEAR(away_from_axis_mm(hole, point), 0.8, 1e-12);
  }
  // A polygon of at least 48 sides: below the circle by at most 6 / 48^2.
  EXPECT_NEAR(length_around_mm(rims[0]), 2.0 * pi * 0.8, 2.0 * pi * 0.8 * 6.0 / (48.0 * 48.0));
}

TEST(HoleRim, OfASlantingEntryIsAnEllipse) {
  const Capsule hole{{-5.0, 15.0, 0.5}, {2.0, 8.0, 0.5}, 0.8};
  const auto rims = rims_of(solid_block({40.0, 20.0, 6.0}), hole);
  ASSERT_EQ(rims.size(), 1U);
  double least_mm = 1e9, most_mm = -1e9;
  for (const Vec3& point : rims[0].points_mm) {
    EXPECT_NEAR(point.y, 10.0, 1e-12);
    EXPECT_NEAR(away_from_axis_mm(hole, point), 0.8, 1e-12);
    least_mm = std::min(least_mm, point.x);
    most_mm = std::max(most_mm, point.x);
  }
  EXPECT_NEAR(most_mm - least_mm, 2.0 * 0.8 * std::sqrt(2.0), 0.01);
}

TEST(HoleRim, OfAHoleThroughTheBoneAreTwoInOrder) {
  const auto rims =
      rims_of(hollow_tube({.inner_radius_mm = 0.0}), {{0.3, 15.0, 1.0}, {0.3, -15.0, 1.0}, 1.0});
  ASSERT_EQ(rims.size(), 2U);
  EXPECT_NEAR(rims[0].way_mm, 15.0 - std::sqrt(63.0), 0.1);
  EXPECT_NEAR(rims[1].way_mm, 15.0 + std::sqrt(63.0), 0.1);
}

TEST(HoleRim, OfAHoleWithinAnEdgeRunsDownBothFaces) {
  const Capsule hole{{9.6, 12.0, 0.0}, {9.6, 5.0, 0.0}, 1.0};
  const IndexedMesh block = solid_block({20.0, 20.0, 20.0});
  const auto rims = rims_of(block, hole);
  // It comes out of the side all the way to the far face: one line around what is taken.
  ASSERT_EQ(rims.size(), 0U);
  const auto through = rims_of(block, {{9.6, 12.0, 0.0}, {9.6, -12.0, 0.0}, 1.0});
  ASSERT_EQ(through.size(), 1U);
  for (const Vec3& point : through[0].points_mm) {
    EXPECT_NEAR(away_from_axis_mm(hole, point), 1.0, 1e-9);
    EXPECT_LE(point.x, 10.0 + 1e-12);
  }
}

TEST(HoleRim, OfAHoleThatGrazesAnEdgeIsNone) {
  // The edge of the block lies 1e-4 mm deep in the cylinder: 0.03 mm of it are taken.
  const IndexedMesh block = solid_block({20.0, 20.0, 20.0});
  const double away_mm = (1.0 - 1.0e-4) / std::sqrt(2.0);
  const Vec3 middle{10.0 + away_mm, 10.0 + away_mm, 0.3};
  const Vec3 way{40.0 / std::sqrt(2.0), -40.0 / std::sqrt(2.0), 0.0};
  EXPECT_TRUE(rims_of(block, {middle - way, middle + way, 1.0}).empty());
  // Deeper it has one, down one face and up the other.
  const Vec3 deeper{10.0 + 0.6, 10.0 + 0.6, 0.3};
  EXPECT_EQ(rims_of(block, {deeper - way, deeper + way, 1.0}).size(), 1U);
}

TEST(HoleRim, OfAHoleThatDoesNotMeetTheSkinIsNone) {
  const IndexedMesh block = solid_block({20.0, 20.0, 20.0});
  EXPECT_TRUE(rims_of(block, {{30.0, 12.0, 0.0}, {30.0, -12.0, 0.0}, 1.0}).empty());
  EXPECT_TRUE(rims_of(block, {{0.0, 3.0, 0.0}, {0.0, -3.0, 0.0}, 1.0}).empty());
}

// Across the axis each step is an arc of the circle or the end of one: neighbours are near there,
// whatever the skin does along the axis; so the line is closed.
RC_GTEST_PROP(HoleRimProperty, IsClosedOnTheSkinAndOnTheCylinder, (std::uint64_t seed)) {
  Random random(seed);
  const IndexedMesh mesh = seed % 4 == 0 ? lattice_bone(random) : random_bone(random);
  const Bvh skin(mesh);
  const Vec3 middle = random.uniform(0.0, 6.0) * random_direction(random);
  const Vec3 way = random_direction(random);
  const Capsule hole{middle - 60.0 * way, middle + 60.0 * way, random.uniform(0.4, 3.0)};
  const AxisFrame frame = frame_along(hole.from_in_body_mm, hole.to_in_body_mm);
  for (const HoleRim& rim : hole_rims(mesh, skin, hole)) {
    RC_ASSERT(rim.points_mm.size() >= 3U);
    Vec3 last = frame.to_local(rim.points_mm.back());
    for (const Vec3& point : rim.points_mm) {
      RC_ASSERT(skin.nearest(point)->distance_mm < 1.0e-8);
      RC_ASSERT(std::abs(away_from_axis_mm(hole, point) - hole.radius_mm) < 1.0e-8);
      const Vec3 local = frame.to_local(point);
      const double step_mm = length_of(Vec2{local.x - last.x, local.y - last.y});
      RC_ASSERT(step_mm < hole.radius_mm * 2.0 * pi / 48.0 + 1.0e-6);
      last = local;
    }
  }
}

}  // namespace
}  // namespace hallux::tests
