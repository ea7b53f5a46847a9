#include "simulator/cutting/solid/opened_volume.h"

#include <gtest/gtest.h>

#include <cmath>

#include "simulator/cutting/slice/plane_slice.h"
#include "tests/simulator/cutting/worlds/cut_through.h"
#include "tests/simulator/cutting/worlds/outlines.h"
#include "tests/simulator/cutting/worlds/random_worlds.h"
#include "tests/support/worlds.h"

namespace hallux::tests {
namespace {

using namespace simulator;

/// Rays square to the plane, `count` by `count` over the region's box: the height of bone on each,
/// summed.
double sampled_mm3(const CutSolid& solid, const KerfPlane& plane, const RegionOutline& region,
                   int count) {
  const KerfAxes axes = axes_of(plane);
  const double half_mm = 0.5 * plane.thickness_mm;
  Vec2 min_mm = region.corners_mm.front(), max_mm = min_mm;
  for (const Vec2& corner_mm : region.corners_mm) {
    min_mm = glm::min(min_mm, corner_mm);
    max_mm = glm::max(max_mm, corner_mm);
  }
  const Vec2 cell_mm = (max_mm - min_mm) / static_cast<double>(count);
  double sum_mm = 0.0;
  const Bvh bvh(solid.mesh);
  const int levels = 4;
  for (int i = 0; i < count; ++i) {
    for (int j = 0; j < count; ++j) {
      const Vec2 place = min_mm + Vec2(i + 0.5, j + 0.5) * cell_mm;
      if (!is_well_inside(region, place, 0.0)) continue;
      for (int level = 0; level < levels; ++level) {
        const double height = half_mm * ((2.0 * level + 1.0) / levels - 1.0);
        const Vec3 point_mm =
            axes.origin_mm + place.x * axes.x + place.y * axes.y + height * axes.z;
        if (bvh.signed_distance_mm(point_mm, 100.0) < 0.0) sum_mm += 2.0 * half_mm / levels;
      }
    }
  }
  return sum_mm * cell_mm.x * cell_mm.y;
}

TEST(OpenedVolume, IsTheBoxThatARectangleTakesFromABlock) {
  const CutSolid block = uncut_solid(solid_block(Vec3(20.0, 10.0, 8.0)));
  const KerfPlane plane = axis_plane(0, 1.0, 0.5);
  EXPECT_NEAR(opened_volume_mm3(block, plane, rectangle_outline(Vec2(-7.0, -6.0), Vec2(1.3, 6.0))),
              6.3 * 8.0 * 0.5, 1e-12 * 25.2);
  EXPECT_NEAR(opened_volume_mm3(block, plane, rectangle_outline(Vec2(-1.0), Vec2(1.0))),
              2.0 * 2.0 * 0.5, 1e-12);
  EXPECT_NEAR(opened_volume_mm3(block, plane, whole_plane()), 40.0, 1e-12 * 40.0);
  EXPECT_EQ(opened_volume_mm3(block, plane, {}), 0.0);
  EXPECT_EQ(opened_volume_mm3(block, axis_plane(0, 11.0, 0.5), whole_plane()), 0.0);
}

TEST(OpenedVolume, LeavesHolesOfTheRegionAndVoidsOfTheBoneOut) {
  const CutSolid tube = uncut_solid(hollow_tube({.segments = 12}));
  const KerfPlane plane = axis_plane(0, 0.1, 0.5);
  const double ring_mm2 = 3.0 * (64.0 - 25.0);
  EXPECT_NEAR(opened_volume_mm3(tube, plane, whole_plane()), 0.5 * ring_mm2, 1e-10);
  // The hole lies in the ring: y from 5.5 to 7.
  const RegionOutline holed =
      outline_from({rectangle_loop(Vec2(-20.0), Vec2(20.0)),
                    turned_back(rectangle_loop(Vec2(5.5, -0.5), Vec2(7.0, 0.5)))});
  EXPECT_NEAR(opened_volume_mm3(tube, plane, holed), 0.5 * (ring_mm2 - 1.5), 1e-10);
}

TEST(OpenedVolume, FollowsABoneThatEndsWithinTheSlab) {
  // Half of the slab's thickness lies beyond the block.
  const CutSolid block = uncut_solid(solid_block(Vec3(20.0, 10.0, 8.0)));
  EXPECT_NEAR(
      opened_volume_mm3(block, axis_plane(0, 10.0, 0.5), rectangle_outline(Vec2(-1.0), Vec2(1.0))),
      2.0 * 2.0 * 0.25, 1e-12);
}

TEST(OpenedVolume, AgreesWithSamples) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    Random random(seed);
    const CutSolid solid = uncut_solid(random_bone(random));
    const KerfPlane plane = random_plane(random);
    const RegionOutline region =
        outline_from({{Vec2(-7.0, -6.1), Vec2(8.3, -3.2), Vec2(5.4, 9.7), Vec2(-6.2, 4.6)}});
    const double sampled = sampled_mm3(solid, plane, region, 40);
    // A place stands for a cell of 0.4 mm. Along a border of some 50 mm the cells are off by up to
    // half, one as often too large as the next too small: about 0.2 * 0.4 * sqrt(50 / 0.4) mm2 of
    // some 100.
    EXPECT_NEAR(opened_volume_mm3(solid, plane, region), sampled, 0.02 * (1.0 + sampled));
  }
}

TEST(OpenedVolume, OfAWholeSectionIsThatOfItsAreas) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Random random(seed);
    const CutSolid solid = uncut_solid(random_bone(random));
    const KerfPlane plane = random_plane(random);
    const double expected_mm3 = cut_through(solid, plane).removed_mm3;
    EXPECT_NEAR(opened_volume_mm3(solid, plane, whole_plane()), expected_mm3,
                1e-9 * (1.0 + expected_mm3))
        << "seed " << seed;
  }
}

}  // namespace
}  // namespace hallux::tests
