#include "simulator/base/transform.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "simulator/base/random.h"
#include "simulator/base/units.h"

namespace hallux {
namespace {

// Some thirty roundings of numbers below 200.
constexpr double accuracy_mm = 30.0 * 200.0 * 2.3e-16;

RigidTransform random_transform(Random& random) {
  const Quat rotation =
      normalised(Quat{random.normal(), random.normal(), random.normal(), random.normal()});
  return {rotation, Vec3{random.uniform(-50.0, 50.0), random.uniform(-50.0, 50.0),
                         random.uniform(-50.0, 50.0)}};
}

double distance(const Vec3& a, const Vec3& b) {
  const Vec3 apart = a - b;
  return std::sqrt(glm::dot(apart, apart));
}

RC_GTEST_PROP(Transform, ProductActsLikeOneAfterTheOther, (std::uint64_t seed)) {
  Random random{seed};
  const RigidTransform a_from_b = random_transform(random);
  const RigidTransform b_from_c = random_transform(random);
  const Vec3 point{random.uniform(-50.0, 50.0), random.uniform(-50.0, 50.0), 7.0};
  const Vec3 at_once = transform_point(a_from_b * b_from_c, point);
  const Vec3 in_turn = transform_point(a_from_b, transform_point(b_from_c, point));
  RC_ASSERT(distance(at_once, in_turn) < accuracy_mm);
}

RC_GTEST_PROP(Transform, InverseTakesBack, (std::uint64_t seed)) {
  Random random{seed};
  const RigidTransform a_from_b = random_transform(random);
  const Vec3 point{random.uniform(-50.0, 50.0), 3.0, random.uniform(-50.0, 50.0)};
  const Vec3 back = transform_point(inverse(a_from_b), transform_point(a_from_b, point));
  RC_ASSERT(distance(back, point) < accuracy_mm);
}

RC_GTEST_PROP(Transform, RotationFromAxesTakesTheAxesThere, (std::uint64_t seed)) {
  Random random{seed};
  const Vec3 x_axis{random.normal(), random.normal(), random.normal()};
  const Vec3 y_hint{random.normal(), random.normal(), random.normal()};
  const Vec3 across = glm::cross(x_axis, y_hint);
  RC_PRE(glm::dot(across, across) > 1.0e-4);
  const RigidTransform turn{rotation_from_axes(x_axis, y_hint), Vec3{0.0}};
  const Vec3 x = transform_direction(turn, Vec3{1.0, 0.0, 0.0});
  const Vec3 y = transform_direction(turn, Vec3{0.0, 1.0, 0.0});
  const Vec3 z = transform_direction(turn, Vec3{0.0, 0.0, 1.0});
  RC_ASSERT(distance(x, x_axis / std::sqrt(glm::dot(x_axis, x_axis))) < 1.0e-12);
  RC_ASSERT(std::fabs(glm::dot(z, y_hint)) < 1.0e-11);
  RC_ASSERT(glm::dot(y, y_hint) > 0.0);
}

TEST(Transform, RotationAboutTurnsByTheRightHand) {
  const RigidTransform quarter{rotation_about(Vec3{0.0, 0.0, 1.0}, 0.5 * pi), Vec3{0.0}};
  const Vec3 turned = transform_direction(quarter, Vec3{1.0, 0.0, 0.0});
  EXPECT_LT(distance(turned, Vec3{0.0, 1.0, 0.0}), 1.0e-15);
}

TEST(Transform, ATurnAboutALineKeepsItsPointsAndTurnsAllOthersAroundIt) {
  const Vec3 point_mm{3.0, -2.0, 5.0}, up{0.0, 0.0, 1.0};
  const RigidTransform quarter = turn_about(point_mm, up, 0.5 * pi);
  EXPECT_LT(distance(transform_point(quarter, point_mm + 7.0 * up), point_mm + 7.0 * up), 1.0e-14);
  EXPECT_LT(distance(transform_point(quarter, point_mm + Vec3{1.0, 0.0, 2.0}),
                     point_mm + Vec3{0.0, 1.0, 2.0}),
            1.0e-14);
}

TEST(Transform, NormalisedMakesTheIdentityOfNothing) {
  EXPECT_EQ(normalised(Quat{0.0, 0.0, 0.0, 0.0}), (Quat{1.0, 0.0, 0.0, 0.0}));
  EXPECT_EQ(normalised(Quat{NAN, 0.0, 0.0, 0.0}), (Quat{1.0, 0.0, 0.0, 0.0}));
}

}  // namespace
}  // namespace hallux
