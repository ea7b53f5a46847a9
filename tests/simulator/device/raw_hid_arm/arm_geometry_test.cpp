// The open serial arm: places that follow from its drawing by hand, and forces against its own
// differences.
#include "simulator/device/raw_hid_arm/arm_geometry.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>

#include "simulator/base/units.h"

namespace hallux::simulator {
namespace {

/// Counts of 1 degree at each joint, not whole.
double counts_per_degree(const ArmGeometry& geometry, std::size_t joint) {
  const double ratio = joint < arm_motors ? geometry.sector_mm[joint] / geometry.capstan_mm : 1.0;
  return geometry.counts_per_turn[joint] / 360.0 * ratio;
}

ArmCounts counts_of(const ArmGeometry& geometry, const std::array<double, arm_encoders>& degrees) {
  ArmCounts counts{};
  for (std::size_t i = 0; i < arm_encoders; ++i) {
    counts[i] = round_to_int32(degrees[i] * counts_per_degree(geometry, i));
  }
  return counts;
}

TEST(ArmGeometry, AtRestTheSecondLinkLiesLevel) {
  const ArmGeometry arm;
  const RigidTransform grip = grip_pose(arm, arm.at_rest);
  // Up: 80 + 205 - 80; to the person: 245 - 220.
  EXPECT_LT(length_of(grip.translation_mm - Vec3(0.0, 205.0, 25.0)), 1e-9);
  EXPECT_NEAR(grip.rotation.w, 1.0, 1e-12);
}

TEST(ArmGeometry, JointATurnsAboutTheVertical) {
  ArmGeometry arm;
  arm.middle_mm = {0.0, 0.0, 0.0};
  const RigidTransform grip = grip_pose(arm, counts_of(arm, {90.0, 0.0, 90.0, 0.0, 0.0, 0.0}));
  // What stood out to the person stands to the right.
  EXPECT_LT(length_of(grip.translation_mm - Vec3(245.0, 285.0, 0.0)), 1e-6);
  const Vec3 forward = transform_direction(grip, {0.0, 0.0, 1.0});
  EXPECT_LT(length_of(forward - Vec3(1.0, 0.0, 0.0)), 1e-9);
}

TEST(ArmGeometry, TheGimbalTurnsAboutItsThreeAxes) {
  const ArmGeometry arm;
  // The outermost is the first that the device names: it rolls the grip about its length.
  const RigidTransform rolled = grip_pose(arm, counts_of(arm, {0.0, 0.0, 90.0, 90.0, 0.0, 0.0}));
  EXPECT_LT(length_of(transform_direction(rolled, {1.0, 0.0, 0.0}) - Vec3(0.0, 1.0, 0.0)), 1e-9);
  const RigidTransform bent = grip_pose(arm, counts_of(arm, {0.0, 0.0, 90.0, 0.0, 90.0, 0.0}));
  EXPECT_LT(length_of(transform_direction(bent, {1.0, 0.0, 0.0}) - Vec3(1.0, 0.0, 0.0)), 1e-9);
}

RC_GTEST_PROP(ArmGeometry, CurrentsDoTheWorkOfTheForce, ()) {
  ArmGeometry arm;
  arm.current_ampere = 1000.0;
  if (*rc::gen::arbitrary<bool>()) arm.direction = {-1.0, 1.0, -1.0, 1.0, -1.0, 1.0};
  ArmCounts counts{};
  for (std::size_t i = 0; i < arm_motors; ++i) counts[i] = *rc::gen::inRange(1'000, 7'000);
  const Vec3 force_newton{*rc::gen::inRange(-30, 31) / 10.0, *rc::gen::inRange(-30, 31) / 10.0,
                          1.3};
  const MotorCurrents currents = motor_currents(arm, counts, force_newton);
  for (std::size_t joint = 0; joint < arm_motors; ++joint) {
    constexpr std::int32_t step = 10;
    ArmCounts after = counts, before = counts;
    after[joint] += step;
    before[joint] -= step;
    const Vec3 way_mm =
        grip_pose(arm, after).translation_mm - grip_pose(arm, before).translation_mm;
    // A motor's torque over the turn of its drum, in newton millimetres.
    const double turn_rad = 2.0 * pi * 2.0 * step / arm.counts_per_turn[joint];
    const double work = currents[joint] * arm.torque_newton_mm_per_ampere[joint] * turn_rad;
    RC_ASSERT(std::abs(work - glm::dot(force_newton, way_mm)) < 1e-4);
  }
}

TEST(ArmGeometry, NoMotorIsGivenMoreThanItsRecordAllows) {
  ArmGeometry arm;
  const MotorCurrents free = motor_currents(arm, arm.at_rest, {0.0, 0.5, 0.0});
  const MotorCurrents much = motor_currents(arm, arm.at_rest, {0.0, 500.0, 0.0});
  EXPECT_NEAR(std::abs(much[2]), arm.current_ampere, 1e-9);
  // The direction of the force stays.
  EXPECT_NEAR(much[1] * free[2], much[2] * free[1], 1e-9);
}

TEST(ArmGeometry, ARecordThatCannotBeIsNamed) {
  EXPECT_EQ(fault_in(ArmGeometry{}), "");
  const auto fault_with = [](auto&& change) {
    ArmGeometry arm;
    change(arm);
    return fault_in(arm);
  };
  EXPECT_NE(fault_with([](ArmGeometry& arm) { arm.second_mm = 0.0; }), "");
  EXPECT_NE(fault_with([](ArmGeometry& arm) { arm.direction[3] = 0.5; }), "");
  EXPECT_NE(fault_with([](ArmGeometry& arm) { arm.counts_per_turn[5] = -1.0; }), "");
  EXPECT_NE(fault_with([](ArmGeometry& arm) { arm.continuous_force_newton = 9.0; }), "");
  EXPECT_NE(fault_with([](ArmGeometry& arm) {
              arm.middle_mm.x = std::numeric_limits<double>::quiet_NaN();
            }),
            "");
  EXPECT_NE(fault_with([](ArmGeometry& arm) {
              arm.torque_newton_mm_per_ampere[1] = std::numeric_limits<double>::infinity();
            }),
            "");
}

}  // namespace
}  // namespace hallux::simulator
