/// The open serial arm (WoodenHaptics, Polhem) as its maker's record describes it, and where its
/// grip is: three joints with motors, three of a gimbal without.
///
///     base --A turns about the upright--> B lifts the first link --> C bears the second --> gimbal
///
/// Frame of the device: x right, y up, z to the person, as of every device here; its origin where
/// the record puts it.
/// source  docs/haptics.md, Devices
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "simulator/base/transform.h"

namespace hallux::simulator {

inline constexpr std::size_t arm_motors = 3, arm_encoders = 6;

/// Of the motors' joints A, B, C, then of the gimbal D, E, F as the device names them.
using ArmCounts = std::array<std::int32_t, arm_encoders>;
using JointAngles = std::array<double, arm_motors>;
using MotorCurrents = std::array<double, arm_motors>;

/// What a record says of an arm; a record that cannot be so is refused where it is read.
struct ArmGeometry {
  std::string name;
  /// Of the base's height, of the first link, of the second.
  double base_mm = 80.0, first_mm = 205.0, second_mm = 245.0;
  /// What the drum on a motor moves of the joint's sector.
  double capstan_mm = 10.0;
  std::array<double, arm_motors> sector_mm{160.0, 120.0, 120.0};
  std::array<double, arm_encoders> counts_per_turn{2000.0, 2000.0, 2000.0, 2000.0, 2000.0, 2000.0};
  /// 1, or -1 where encoder and motor turn against the joint.
  std::array<double, arm_encoders> direction{1.0, 1.0, 1.0, 1.0, 1.0, 1.0};
  /// Of each motor.
  std::array<double, arm_motors> torque_newton_mm_per_ampere{321.0, 60.3, 60.3};
  double current_ampere = 2.0;
  /// That the workspace has in its middle, seen from the axis of A at the height of the table: out
  /// to the person, to the right, up.
  Vec3 middle_mm{220.0, 0.0, 80.0};
  double workspace_radius_mm = 100.0;
  double force_newton = 5.0, continuous_force_newton = 2.5;
  double stiffness_newton_per_mm = 1.0, damping_newton_s_per_mm = 0.008;
  /// What the encoders say where the arm rests in its stand.
  ArmCounts at_rest{0, 0, 6000, 0, 0, 0};
};

/// Empty, or what cannot be of it, in a few words: a length of 0, a direction that is neither 1 nor
/// -1, no number.
std::string fault_in(const ArmGeometry& geometry);

JointAngles joint_angles(const ArmGeometry& geometry, const ArmCounts& counts) noexcept;

/// Where the grip is and how it is turned, from what the encoders say.
RigidTransform grip_pose(const ArmGeometry& geometry, const ArmCounts& counts) noexcept;

/// The currents [A] with which the motors push the grip with that force [N, frame of the device].
/// ensures none above the record's; where one would be, all are made smaller alike
MotorCurrents motor_currents(const ArmGeometry& geometry, const ArmCounts& counts,
                             const Vec3& force_newton) noexcept;

}  // namespace hallux::simulator
