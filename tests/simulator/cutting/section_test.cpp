#include "simulator/cutting/section.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/simulator/cutting/cut_through.h"
#include "tests/support/worlds.h"

namespace hallux::tests {
namespace {

using namespace simulator;

TEST(Section, HoldsOuterContoursLeftAndHolesRightTurning) {
  const CutSolid solid = uncut_solid(hollow_tube({.rings = 3}));
  const Section section = slice_section(solid, Bvh(solid.mesh), axis_plane(0, 2.0, 0.5));
  ASSERT_EQ(section.regions.size(), 1U);
  ASSERT_EQ(section.regions[0].contours.size(), 2U);
  int left = 0, right = 0;
  for (const Contour& contour : section.regions[0].contours) {
    double area_mm2 = 0.0;
    for (std::size_t i = 0; i < contour.size(); ++i) {
      const Vec2& a = contour[i];
      const Vec2& b = contour[(i + 1) % contour.size()];
      area_mm2 += 0.5 * (a.x * b.y - a.y * b.x);
    }
    ++(area_mm2 > 0.0 ? left : right);
  }
  EXPECT_EQ(left, 1);
  EXPECT_EQ(right, 1);
  EXPECT_NEAR(section.regions[0].min_mm.x, -8.0, 1e-9);
  EXPECT_NEAR(section.regions[0].max_mm.y, 8.0, 1e-9);
}

TEST(Section, RegionsComeLargestFirst) {
  IndexedMesh mesh = solid_block(Vec3(2.0));
  append_mesh(mesh, moved(solid_block(Vec3(5.0)), {Quat(1, 0, 0, 0), Vec3(20.0, 0.0, 0.0)}));
  const CutSolid solid = uncut_solid(mesh);
  const Section section = slice_section(solid, Bvh(solid.mesh), axis_plane(2, 0.1, 0.5));
  ASSERT_EQ(section.regions.size(), 2U);
  EXPECT_NEAR(section.regions[0].area_mm2, 25.0, 1e-12);
  EXPECT_NEAR(section.regions[1].area_mm2, 4.0, 1e-12);
}

TEST(Section, TheMaskHoldsEveryPlaceTheSlabReaches) {
  const CutSolid solid = uncut_solid(sphere(6.0, 8));
  const Bvh bvh(solid.mesh);
  // Near the pole the projected skin is much wider than the section at the middle plane.
  const KerfPlane plane = axis_plane(2, 5.2, 0.8);
  const Section section = slice_section(solid, bvh, plane);
  const FieldGrid grid{.origin_mm = Vec2(-10.0), .spacing_mm = 0.1, .u_count = 201, .v_count = 201};
  const SectionMask mask = mask_section(section, solid, bvh, grid);
  ASSERT_EQ(mask.fits_grid, (std::vector<std::uint8_t>{1}));
  std::int32_t counted = 0;
  for (std::int32_t v = 0; v < grid.v_count; ++v) {
    for (std::int32_t u = 0; u < grid.u_count; ++u) {
      const bool is_region = mask.region_of_node[static_cast<std::size_t>(v * 201 + u)] == 0;
      counted += is_region ? 1 : 0;
      const Vec3 node_mm(-10.0 + 0.1 * u, -10.0 + 0.1 * v, 4.8 + 1e-9);
      if (bvh.contains(node_mm)) {
        EXPECT_TRUE(is_region);
      }
      // And no further than the cells around it: the widest height is the slab's lower plane.
      const double outside_mm = std::sqrt(node_mm.x * node_mm.x + node_mm.y * node_mm.y);
      if (outside_mm > 3.6 + 0.3) {
        EXPECT_FALSE(is_region);
      }
    }
  }
  EXPECT_EQ(counted, mask.node_count[0]);
}

TEST(Section, ARegionBeyondTheGridDoesNotFit) {
  const CutSolid solid = uncut_solid(solid_block(Vec3(10.0)));
  const Bvh bvh(solid.mesh);
  const Section section = slice_section(solid, bvh, axis_plane(2, 0.0, 0.5));
  const FieldGrid grid{.origin_mm = Vec2(-4.0), .spacing_mm = 0.1, .u_count = 201, .v_count = 201};
  const SectionMask mask = mask_section(section, solid, bvh, grid);
  EXPECT_EQ(mask.fits_grid, (std::vector<std::uint8_t>{0}));
  EXPECT_EQ(mask.node_count, (std::vector<std::int32_t>{0}));
}

}  // namespace
}  // namespace hallux::tests
