#include "simulator/cutting/hole/capsule.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "simulator/base/random.h"
#include "tests/simulator/cutting/worlds/random_worlds.h"

namespace hallux::tests {
namespace {

using namespace simulator;

const Capsule along_x{{0.0, 0.0, 0.0}, {10.0, 0.0, 0.0}, 1.0};

TEST(Capsule, IsNearAPointBesideItAndBeyondItsEnds) {
  EXPECT_NEAR(distance_mm(along_x, Vec3(5.0, 3.0, 0.0)), 2.0, 1e-12);
  EXPECT_NEAR(distance_mm(along_x, Vec3(13.0, 0.0, 4.0)), 4.0, 1e-12);
  EXPECT_NEAR(distance_mm(along_x, Vec3(5.0, 0.25, 0.0)), -0.75, 1e-12);
}

TEST(Capsule, OfTwoCoincidingEndsIsABall) {
  const Capsule ball{{1.0, 1.0, 1.0}, {1.0, 1.0, 1.0}, 0.5};
  EXPECT_NEAR(distance_mm(ball, Vec3(1.0, 4.0, 5.0)), 4.5, 1e-12);
  EXPECT_NEAR(distance_mm(ball, along_x), std::sqrt(2.0) - 1.5, 1e-12);
}

TEST(Capsule, ThatCrossesAnotherOverlapsItByBothRadii) {
  const Capsule across{{5.0, 0.0, -4.0}, {5.0, 0.0, 4.0}, 0.5};
  EXPECT_NEAR(distance_mm(along_x, across), -1.5, 1e-12);
  EXPECT_NEAR(distance_mm(along_x, axis_of(across)), -1.0, 1e-12);
}

TEST(Capsule, BesideAParallelOneIsAsFarAsTheirAxesLessBothRadii) {
  const Capsule beside{{2.0, 4.0, 0.0}, {30.0, 4.0, 0.0}, 0.5};
  EXPECT_NEAR(distance_mm(along_x, beside), 2.5, 1e-12);
  EXPECT_NEAR(distance_mm(beside, along_x), 2.5, 1e-12);
}

TEST(Capsule, HoldsItsInsideAndNotItsSurface) {
  const std::array<Capsule, 2> both{along_x, Capsule{{0.0, 9.0, 0.0}, {0.0, 12.0, 0.0}, 1.0}};
  EXPECT_TRUE(is_in_capsule(both, Vec3(0.0, 10.0, 0.5)));
  EXPECT_TRUE(is_in_capsule(both, Vec3(10.5, 0.0, 0.0)));
  EXPECT_FALSE(is_in_capsule(both, Vec3(5.0, 1.0, 0.0)));
  EXPECT_FALSE(is_in_capsule({}, Vec3(0.0, 0.0, 0.0)));
}

Vec3 random_point(Random& random) {
  return {random.uniform(-10.0, 10.0), random.uniform(-10.0, 10.0), random.uniform(-10.0, 10.0)};
}

// A step along both axes is at most 1/200 of their lengths, so the samples' least distance is above
// the true one by at most half a step of each.
RC_GTEST_PROP(CapsuleProperty, DistancesAreThoseOfSamples, (std::uint64_t seed)) {
  Random random(seed);
  const Capsule a{random_point(random), random_point(random), random.uniform(0.1, 2.0)};
  Capsule b{random_point(random), random_point(random), random.uniform(0.1, 2.0)};
  if (seed % 3 == 0) {  // nearly parallel
    const Vec3 aside = random.uniform(0.0, 5.0) * random_direction(random);
    b.from_in_body_mm = a.from_in_body_mm + aside;
    b.to_in_body_mm = a.to_in_body_mm + aside + 1.0e-9 * random_direction(random);
  }
  const int parts = 200;
  double least_mm = 1.0e9;
  for (int i = 0; i <= parts; ++i) {
    const Vec3 on_b = b.from_in_body_mm +
                      (static_cast<double>(i) / parts) * (b.to_in_body_mm - b.from_in_body_mm);
    double point_least_mm = 1.0e9;
    for (int k = 0; k <= parts; ++k) {
      const Vec3 on_a = a.from_in_body_mm +
                        (static_cast<double>(k) / parts) * (a.to_in_body_mm - a.from_in_body_mm);
      point_least_mm = std::min(point_least_mm, length_of(on_a - on_b));
    }
    const double half_step_mm = 0.5 * length_of(a.to_in_body_mm - a.from_in_body_mm) / parts;
    const double exact_mm = distance_mm(a, on_b) + a.radius_mm;
    RC_ASSERT(exact_mm <= point_least_mm + 1.0e-9);
    RC_ASSERT(exact_mm >= point_least_mm - half_step_mm - 1.0e-9);
    least_mm = std::min(least_mm, point_least_mm);
  }
  const double steps_mm = (length_of(a.to_in_body_mm - a.from_in_body_mm) +
                           length_of(b.to_in_body_mm - b.from_in_body_mm)) /
                          (2.0 * parts);
  const double exact_mm = distance_mm(a, b) + a.radius_mm + b.radius_mm;
  RC_ASSERT(exact_mm <= least_mm + 1.0e-9);
  RC_ASSERT(exact_mm >= least_mm - steps_mm - 1.0e-9);
  RC_ASSERT(std::abs(exact_mm - (distance_mm(b, a) + a.radius_mm + b.radius_mm)) < 1.0e-6);
}

}  // namespace
}  // namespace hallux::tests
