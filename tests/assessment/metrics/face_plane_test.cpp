#include "assessment/metrics/face_plane.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

#include "simulator/base/units.h"

namespace hallux::assessment {
namespace {

/// 41 x 41 points of the plane z = slope x, half a millimetre apart.
std::vector<Vec3> sloped_square(double slope) {
  std::vector<Vec3> points_mm;
  for (int i = -20; i <= 20; ++i) {
    for (int j = -20; j <= 20; ++j) {
      const double x = 0.5 * i;
      points_mm.emplace_back(x, 0.5 * j, slope * x);
    }
  }
  return points_mm;
}

TEST(FacePlane, FindsAnExactPlaneAndLooksToTheSideAskedFor) {
  const std::optional<FacePlane> up = fit_plane(sloped_square(0.75), Vec3{0.0, 0.0, 1.0});
  ASSERT_TRUE(up);
  EXPECT_NEAR(up->normal.x, -0.6, 1e-12);
  EXPECT_NEAR(up->normal.z, 0.8, 1e-12);
  EXPECT_NEAR(up->offset_mm, 0.0, 1e-12);
  const std::optional<FacePlane> down = fit_plane(sloped_square(0.75), Vec3{0.0, 0.0, -1.0});
  EXPECT_NEAR(down->normal.z, -0.8, 1e-12);
}

TEST(FacePlane, AFewFarPointsDoNotTurnThePlane) {
  std::vector<Vec3> points_mm = sloped_square(0.0);
  for (int i = 0; i < 20; ++i) points_mm.emplace_back(10.0, 0.1 * i, 3.0);
  const std::optional<FacePlane> plane = fit_plane(points_mm, Vec3{0.0, 0.0, 1.0});
  ASSERT_TRUE(plane);
  EXPECT_NEAR(plane->normal.z, 1.0, 1e-12);
}

TEST(FacePlane, PointsOnALineMeanNoPlane) {
  std::vector<Vec3> points_mm(50);
  for (std::size_t i = 0; i < points_mm.size(); ++i) {
    points_mm[i] = static_cast<double>(i) * Vec3{0.1, 0.2, -0.3};
  }
  EXPECT_FALSE(fit_plane(points_mm, Vec3{0.0, 0.0, 1.0}));
  EXPECT_FALSE(fit_plane(std::span(points_mm).first(2), Vec3{0.0, 0.0, 1.0}));
}

TEST(FacePlane, MovingThePointsMovesThePlaneWithThem) {
  rc::check([] {
    const auto part = [] { return static_cast<double>(*rc::gen::inRange(-1000, 1000)) / 100.0; };
    const Vec3 moved_mm{part(), part(), part()};
    std::vector<Vec3> points_mm = sloped_square(0.5);
    const FacePlane before = *fit_plane(points_mm, Vec3{0.0, 0.0, 1.0});
    for (Vec3& point : points_mm) point += moved_mm;
    const FacePlane after = *fit_plane(points_mm, Vec3{0.0, 0.0, 1.0});
    RC_ASSERT(angle_between_rad(before.normal, after.normal) < 1e-10);
    RC_ASSERT(std::abs(signed_distance_mm(after, moved_mm)) < 1e-10);
  });
}

TEST(FacePlane, SmallAnglesAreExact) {
  const Vec3 tilted{std::sin(1e-9), 0.0, std::cos(1e-9)};
  EXPECT_NEAR(angle_between_rad(tilted, Vec3{0.0, 0.0, 1.0}), 1e-9, 1e-20);
  EXPECT_NEAR(angle_between_rad(Vec3{0.0, 0.0, -1.0}, Vec3{0.0, 0.0, 1.0}), pi, 1e-15);
}

TEST(FacePlane, PercentilesAreLinearBetweenNeighbours) {
  EXPECT_DOUBLE_EQ(percentile({4.0, 1.0, 3.0, 2.0}, 0.5), 2.5);
  EXPECT_DOUBLE_EQ(percentile({4.0, 1.0, 3.0, 2.0}, 1.0), 4.0);
  EXPECT_DOUBLE_EQ(percentile({7.0}, 0.025), 7.0);
}

}  // namespace
}  // namespace hallux::assessment
