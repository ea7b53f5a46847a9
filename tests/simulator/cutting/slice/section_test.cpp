#include "simulator/cutting/slice/section.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/simulator/cutting/worlds/cut_through.h"
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

}  // namespace
}  // namespace hallux::tests
