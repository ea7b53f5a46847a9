#include "assessment/metrics/blade_flatness.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "simulator/base/units.h"

namespace hallux::assessment {
namespace {

/// A blade led along x, 10 mm wide, with the given height above its plane at each tick.
std::vector<ToothPoint> stroke(const std::vector<double>& heights_mm) {
  std::vector<ToothPoint> points;
  for (std::size_t tick = 0; tick < heights_mm.size(); ++tick) {
    for (const double y_mm : {-5.0, 0.0, 5.0}) {
      points.push_back({Vec3{0.01 * static_cast<double>(tick), y_mm, heights_mm[tick]},
                        static_cast<std::int64_t>(tick)});
    }
  }
  return points;
}

TEST(BladeFlatness, ABladeThatKeepsItsPlaneIsFlat) {
  const std::optional<Flatness> flatness = measure_flatness(stroke(std::vector(500, 2.0)));
  ASSERT_TRUE(flatness);
  EXPECT_NEAR(flatness->flatness_mm, 0.0, 1e-12);
}

TEST(BladeFlatness, AWaveIsAsUnflatAsItsPercentilesAreApart) {
  // Alternating by 0.4 mm every tick: half of the residuals at either side of the middle plane.
  std::vector<double> heights_mm(500, 0.0);
  for (std::size_t tick = 0; tick < heights_mm.size(); tick += 2) heights_mm[tick] = 0.4;
  const std::optional<Flatness> flatness = measure_flatness(stroke(heights_mm));
  ASSERT_TRUE(flatness);
  // The fit tilts by less than 0.4 mm x 12 / 500^2 per tick: within 1e-2 mm over the stroke.
  EXPECT_NEAR(flatness->flatness_mm, 0.4, 1e-2);
}

TEST(BladeFlatness, OfASineIsKnownWithinItsBound) {
  for (const std::size_t ticks_a_turn : {40U, 125U, 250U}) {
    std::vector<double> heights_mm;
    for (std::size_t tick = 0; tick < 20 * ticks_a_turn; ++tick)
      heights_mm.push_back(
          0.3 * std::cos(2.0 * pi * static_cast<double>(tick) / static_cast<double>(ticks_a_turn)));
    const std::optional<Flatness> flatness = measure_flatness(stroke(heights_mm));
    ASSERT_TRUE(flatness);
    // A cosine lies above that of a fortieth of half a turn for a fortieth of the time.
    const double exact_mm = 2.0 * 0.3 * std::cos(0.025 * pi);
    EXPECT_NEAR(flatness->flatness_mm, exact_mm, flatness->bound_mm) << ticks_a_turn;
    EXPECT_LT(flatness->bound_mm, 0.1);
  }
}

TEST(BladeFlatness, NamesTheTickThatWasWorst) {
  std::vector<double> heights_mm(500, 0.0);
  heights_mm[321] = 0.7;
  const std::optional<Flatness> flatness = measure_flatness(stroke(heights_mm));
  ASSERT_TRUE(flatness);
  EXPECT_EQ(flatness->tick, 321);
  EXPECT_DOUBLE_EQ(flatness->point_in_bone_mm.z, 0.7);
  EXPECT_NEAR(flatness->flatness_mm, 0.0, 1e-9);
}

TEST(BladeFlatness, ABladeThatStoodStillTellsNothing) {
  EXPECT_FALSE(measure_flatness({}));
  EXPECT_FALSE(measure_flatness(stroke({1.0})));
}

}  // namespace
}  // namespace hallux::assessment
