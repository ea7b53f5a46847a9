#include "scenarios/foot/bone_field.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "scenarios/foot/first_metatarsal.h"
#include "scenarios/foot/first_proximal_phalanx.h"
#include "scenarios/foot/relief.h"
#include "tests/scenarios/foot/measured_phalanx.h"

namespace hallux::scenarios {
namespace {

/// A point in [low, high) of a box, from whole numbers so that RapidCheck can shrink it.
Vec3 point_in(const Vec3& low, const Vec3& high) {
  const auto share = [] { return static_cast<double>(*rc::gen::inRange(0, 10000)) / 10000.0; };
  const Vec3 shares{share(), share(), share()};
  return low + (high - low) * shares;
}

Vec3 slope_by_differences(const std::function<double(const Vec3&)>& value, const Vec3& at) {
  constexpr double h = 1e-5;
  const auto along = [&](const Vec3& step) {
    return (value(at + step) - value(at - step)) / (2 * h);
  };
  return {along({h, 0, 0}), along({0, h, 0}), along({0, 0, h})};
}

RC_GTEST_PROP(Relief, CarriesItsOwnSlope, ()) {
  const Vec3 at = point_in({-20, -20, -20}, {20, 20, 20});
  const Vec3 expected = slope_by_differences([](const Vec3& p) { return relief_at(p).value; }, at);
  const Vec3 wrong = relief_at(at).slope - expected;
  // Central differences err by h^2 / 6 times the third derivative, below 60 / 1.6^3 here.
  RC_ASSERT(std::sqrt(glm::dot(wrong, wrong)) < 1e-6);
}

/// Where a ray from the x axis leaves the bone.
Vec3 surface_point(const BoneField& field, double x_mm, double angle_rad) {
  const Vec3 direction{0.0, std::cos(angle_rad), std::sin(angle_rad)};
  double inside_mm = 0.0;
  double outside_mm = 25.0;
  while (outside_mm - inside_mm > 1e-6) {
    const double middle_mm = 0.5 * (inside_mm + outside_mm);
    const bool is_inside = field.at(Vec3{x_mm, 0.0, 0.0} + middle_mm * direction).value < 0.0;
    (is_inside ? inside_mm : outside_mm) = middle_mm;
  }
  return Vec3{x_mm, 0.0, 0.0} + outside_mm * direction;
}

RC_GTEST_PROP(BoneField, PutsAnyPointNearTheSurfaceOntoIt, ()) {
  const BoneField field(first_metatarsal_table(), 63.2, 4.0);
  const Vec3 draw = point_in({3.0, 0.0, -0.5}, {59.0, 6.28, 0.5});
  const Vec3 start = surface_point(field, draw.x, draw.y) + Vec3{0.0, draw.z, draw.z};
  const Vec3 found = field.onto_surface(start);
  RC_ASSERT(std::abs(field.at(found).value) < 1e-3);
  RC_ASSERT(glm::dot(found - start, found - start) < 4.0);
}

TEST(BoneField, IsInsideOnTheAxisAndOutsideTheBox) {
  const BoneField field(first_metatarsal_table(), 63.2, 0.0);
  for (double x = 4.0; x < 60.0; x += 4.0) EXPECT_LT(field.at({x, 0.0, 0.0}).value, 0.0) << x;
  EXPECT_GT(field.at(field.low_mm()).value, 0.0);
  EXPECT_GT(field.at(field.high_mm()).value, 0.0);
  EXPECT_GT(field.at({-0.5, 0.0, 0.0}).value, 0.0);
  EXPECT_GT(field.at({63.7, 0.0, 0.0}).value, 0.0);
}

TEST(BoneField, ChangesNothingOnTheShaftWhereAnEminenceGrows) {
  const BoneField plain(first_metatarsal_table(), 63.2, 0.0);
  const BoneField grown(first_metatarsal_table(), 63.2, 6.0);
  for (double x = 2.0; x < 33.0; x += 1.0) {
    const Vec3 at = plain.onto_surface({x, 0.0, -8.0});
    EXPECT_NEAR(grown.at(at).value, 0.0, 1e-6) << x;
  }
}

TEST(BoneField, ChangesNothingOnTheShaftWhereTheBaseFacetTilts) {
  const BoneField level(first_proximal_phalanx_table(), 33.0, 0.0);
  const BoneField oblique(scenarios_test::measured_phalanx_table(), 33.0, 0.0);
  for (double x = 13.0; x < 32.0; x += 1.0) {
    const Vec3 at = level.onto_surface({x, 1.0, 9.0});
    EXPECT_NEAR(oblique.at(at).value, 0.0, 1e-9) << x;
  }
  const Vec3 rim = level.onto_surface({0.0, -5.0, 7.0});
  EXPECT_GT(std::abs(oblique.at(rim).value), 1.0);
}

/// A step shows as a crease across the facet or the head.
TEST(BoneField, HasNoStepWhereTheSectionsEnd) {
  for (const BoneTable& table : {first_metatarsal_table(), first_proximal_phalanx_table()}) {
    const BoneField field(table, table.length_mm, 0.0);
    for (const Station& end : {table.stations.front(), table.stations.back()}) {
      const double x = end.position * table.length_mm;
      for (double angle_rad = 0.0; angle_rad < 6.28; angle_rad += 0.05) {
        const Vec3 at = surface_point(field, x, angle_rad);
        const double before = field.at(at - Vec3{1e-7, 0.0, 0.0}).value;
        const double after = field.at(at + Vec3{1e-7, 0.0, 0.0}).value;
        // The slope is below 2, so over 2e-7 mm the value changes by less than 4e-7.
        EXPECT_NEAR(before, after, 4e-7) << table.bone << " at " << x << ", " << angle_rad;
      }
    }
  }
}

}  // namespace
}  // namespace hallux::scenarios
