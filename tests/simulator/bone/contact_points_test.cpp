#include "simulator/bone/contact_points.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/worlds.h"

namespace hallux::simulator {
namespace {

/// A block of 8 mm whose faces at +y and +x were sawn.
CutSolid sawn_block() {
  CutSolid solid = uncut_solid(tests::solid_block({8.0, 8.0, 8.0}));
  for (std::size_t i = 0; i < solid.mesh.triangles.size(); ++i) {
    const Vec3 middle = middle_of(corners_of(solid.mesh, i));
    if (middle.y > 3.9) solid.sources[i] = {0, 1};
    if (middle.x > 3.9) solid.sources[i] = {1, 1};
  }
  return solid;
}

bool is_tip(const Vec3& point) { return point.x > 3.9 && point.y > 3.9; }
bool is_on_rim(const Vec3& point) { return point.x > 3.9 || point.y > 3.9; }

TEST(ContactPoints, BeginWithTipsThenRimsThenSkin) {
  const std::vector<Vec3> points = contact_points(sawn_block(), 32);
  ASSERT_EQ(points.size(), 8U);
  EXPECT_TRUE(std::all_of(points.begin(), points.begin() + 2, is_tip));
  EXPECT_TRUE(std::all_of(points.begin(), points.begin() + 6, is_on_rim));
  EXPECT_TRUE(std::none_of(points.begin() + 6, points.end(), is_on_rim));
}

TEST(ContactPoints, AreNoMoreThanAskedForAndNoneTwice) {
  for (std::size_t most = 0; most < 12; ++most) {
    std::vector<Vec3> points = contact_points(sawn_block(), most);
    EXPECT_EQ(points.size(), std::min<std::size_t>(most, 8));
    for (std::size_t i = 0; i < points.size(); ++i)
      EXPECT_EQ(std::count(points.begin(), points.end(), points[i]), 1);
  }
}

TEST(ContactPoints, OfABoneThatWasNeverSawnLieOnItsSkin) {
  EXPECT_EQ(contact_points(uncut_solid(tests::solid_block({8.0, 8.0, 8.0})), 32).size(), 8U);
}

}  // namespace
}  // namespace hallux::simulator
