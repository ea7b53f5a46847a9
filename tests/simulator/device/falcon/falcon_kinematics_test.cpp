// The Falcon's legs against places and forces that were computed independently of this code
// (docs/haptics.md, Devices), and against themselves.
#include "simulator/device/falcon/falcon_kinematics.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <glm/mat3x3.hpp>

#include "simulator/base/units.h"
#include "tests/support/served_bus/falcon_counts.h"

namespace hallux::simulator {
namespace {

struct Known {
  Vec3 grip_mm;
  CrankAngles angles_deg;
  FalconCounts counts;
};

const Known known[] = {
    {{0.0, 0.0, 75.0}, {-18.3195, -18.3195, -18.3195}, {-1463, -1463, -1463}},
    {{0.0, 0.0, 110.0}, {16.1880, 16.1880, 16.1880}, {-516, -516, -516}},
    {{0.0, 0.0, 150.0}, {47.2433, 47.2433, 47.2433}, {336, 336, 336}},
    {{30.0, 0.0, 120.0}, {33.6711, 8.0782, 40.2477}, {-36, -739, 144}},
    {{0.0, 30.0, 120.0}, {8.3704, 32.5769, 41.0273}, {-731, -67, 165}},
    {{-20.0, 20.0, 130.0}, {19.3950, 47.9655, 35.8338}, {-428, 356, 23}},
};

/// Within which a person moves it.
rc::Gen<Vec3> places() {
  const auto between = [](int least, int most) {
    return rc::gen::map(rc::gen::inRange(least * 100, most * 100),
                        [](int value) { return value / 100.0; });
  };
  return rc::gen::map(
      rc::gen::tuple(between(-35, 35), between(-35, 35), between(85, 160)),
      [](const auto& at) { return Vec3(std::get<0>(at), std::get<1>(at), std::get<2>(at)); });
}

TEST(FalconKinematics, CranksStandAsTheReferenceSays) {
  for (const Known& each : known) {
    const std::optional<CrankAngles> angles = crank_angles(each.grip_mm);
    ASSERT_TRUE(angles);
    for (std::size_t leg = 0; leg < falcon_legs; ++leg) {
      EXPECT_NEAR(degree_from_radian((*angles)[leg]), each.angles_deg[leg], 6e-5);
    }
    EXPECT_EQ(tests::falcon_counts_at(each.grip_mm), each.counts);
  }
}

TEST(FalconKinematics, TheGripIsWhereTheReferenceSays) {
  const std::pair<FalconCounts, Vec3> places[] = {{{0, 0, 0}, {0.0, 0.0, 134.602}},
                                                  {{300, -200, 100}, {14.528, -11.579, 136.148}},
                                                  {{500, 500, 500}, {0.0, 0.0, 156.860}},
                                                  {{-500, -500, -500}, {0.0, 0.0, 110.754}}};
  for (const auto& [counts, place_mm] : places) {
    const std::optional<Vec3> grip_mm = grip_place(crank_angles_at(counts), falcon_middle_mm);
    ASSERT_TRUE(grip_mm);
    EXPECT_LT(length_of(*grip_mm - place_mm), 1e-3);
  }
}

TEST(FalconKinematics, AForceNeedsTheTorquesThatTheReferenceSays) {
  const Vec3 grip_mm{0.0, 0.0, 110.0};
  const CrankRates rates = crank_rates(grip_mm, crank_angles(grip_mm).value());
  // 10,000 counts for a newton metre, pulling.
  const auto counts = [&](const Vec3& force_newton) {
    return -10.0 * crank_torques(rates, force_newton);
  };
  EXPECT_LT(length_of(counts({1.0, 0.0, 0.0}) - Vec3(-155.0, 527.0, -372.0)), 1.0);
  EXPECT_LT(length_of(counts({0.0, 1.0, 0.0}) - Vec3(519.0, -126.0, -394.0)), 1.0);
  EXPECT_LT(length_of(counts({0.0, 0.0, 1.0}) - Vec3(-242.0, -242.0, -242.0)), 1.0);
}

RC_GTEST_PROP(FalconKinematics, TheGripIsFoundAgainFromItsCranks, ()) {
  const Vec3 grip_mm = *places();
  const std::optional<CrankAngles> angles = crank_angles(grip_mm);
  RC_PRE(angles.has_value());
  const std::optional<Vec3> found_mm = grip_place(*angles, falcon_middle_mm);
  RC_ASSERT(found_mm.has_value());
  RC_ASSERT(length_of(*found_mm - grip_mm) < 1e-6);
}

RC_GTEST_PROP(FalconKinematics, RatesAreTheDifferencesOfAngles, ()) {
  const Vec3 grip_mm = *places();
  const std::optional<CrankAngles> angles = crank_angles(grip_mm);
  RC_PRE(angles.has_value());
  const CrankRates rates = crank_rates(grip_mm, *angles);
  constexpr double step_mm = 1e-4;
  for (glm::length_t axis = 0; axis < 3; ++axis) {
    Vec3 step{0.0, 0.0, 0.0};
    step[axis] = step_mm;
    const std::optional<CrankAngles> after = crank_angles(grip_mm + step);
    const std::optional<CrankAngles> before = crank_angles(grip_mm - step);
    RC_PRE(after.has_value() && before.has_value());
    for (std::size_t leg = 0; leg < falcon_legs; ++leg) {
      const double difference = ((*after)[leg] - (*before)[leg]) / (2.0 * step_mm);
      RC_ASSERT(std::abs(rates[leg][axis] - difference) < 1e-7);
    }
  }
}

RC_GTEST_PROP(FalconKinematics, TorquesDoTheWorkOfTheForce, ()) {
  const Vec3 grip_mm = *places();
  const std::optional<CrankAngles> angles = crank_angles(grip_mm);
  RC_PRE(angles.has_value());
  const CrankRates rates = crank_rates(grip_mm, *angles);
  const Vec3 force_newton{1.5, -2.0, 0.7}, way_mm{0.3, 0.2, -0.1};
  const Vec3 torques = crank_torques(rates, force_newton);
  double work = 0.0;
  for (std::size_t leg = 0; leg < falcon_legs; ++leg) {
    work += torques[static_cast<glm::length_t>(leg)] * glm::dot(rates[leg], way_mm);
  }
  RC_ASSERT(std::abs(work - glm::dot(force_newton, way_mm)) < 1e-9);
}

TEST(FalconKinematics, WhereTheLegsDoNotReachThereIsNoPlace) {
  EXPECT_FALSE(crank_angles({0.0, 0.0, 400.0}));
  EXPECT_FALSE(crank_angles({200.0, 0.0, 120.0}));
  EXPECT_FALSE(grip_place(crank_angles_at({32767, -32768, 32767}), falcon_middle_mm));
  EXPECT_EQ(crank_torques(CrankRates{}, {1.0, 1.0, 1.0}), Vec3(0.0, 0.0, 0.0));
}

}  // namespace
}  // namespace hallux::simulator
