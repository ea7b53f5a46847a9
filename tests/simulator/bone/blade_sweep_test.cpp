#include "simulator/bone/blade_sweep.h"

#include <gtest/gtest.h>

#include "simulator/base/units.h"
#include "simulator/cutting/field/region_outline.h"
#include "tests/support/outline_area.h"

namespace hallux::simulator {
namespace {

TEST(BladeSweep, OpensTheKerfThatIsThereThoughItsPlaneIsAnother) {
  const Quat rotation = rotation_from_axes(Vec3(0.0, 1.0, 0.0), Vec3(0.0, 0.0, 1.0));
  const KerfPlane kerf{{rotation, Vec3(1.08, 2.0, 0.0)}, 0.5};
  const Vec3 dorsal(0.0, 1.0, 0.0);
  const BladePath path = path_in_plane(
      {13.0, 30.0, {{Vec3(1.0, -20.0, 0.0), dorsal}, {Vec3(1.0, 7.5, 0.0), dorsal}}}, kerf);
  EXPECT_EQ(path.blade.width_mm, 13.0);
  EXPECT_EQ(path.blade.depth_mm, 30.0);
  EXPECT_EQ(path.blade.kerf_mm, 0.5);
  ASSERT_EQ(path.poses.size(), 2U);
  EXPECT_NEAR(path.poses[1].tip_mm.x, 5.5, 1e-12);
  EXPECT_NEAR(path.poses[1].tip_mm.y, 0.0, 1e-12);
  EXPECT_NEAR(path.poses[1].direction.x, 1.0, 1e-12);
}

/// A quarter turn about the tip: a sector, and beside each of its sides half the blade's width.
TEST(BladeSweep, ATurnOfTheBladeOpensTheSectorThatItPasses) {
  const Blade blade{1.0, 8.0, 0.5};
  const PlanarPose from{{0.0, 0.0}, {1.0, 0.0}}, to{{0.0, 0.0}, {0.0, 1.0}};
  KerfField field({.origin_mm = {-10.0, -10.0}, .u_count = 401, .v_count = 401});
  stamp_motion(field, blade, from, to);
  const double sides_mm2 = 2.0 * 0.5 * 8.0;
  const double corner_mm2 = 8.0 * 8.0 + 0.5 * 0.5;  // the blade's far corners run a little outside
  const double opened_mm2 = tests::area_mm2(outline_of(field));
  EXPECT_GT(opened_mm2, 0.25 * pi * 8.0 * 8.0 + sides_mm2 - 0.05);
  EXPECT_LT(opened_mm2, 0.25 * pi * corner_mm2 + sides_mm2 + 0.5);
}

}  // namespace
}  // namespace hallux::simulator
