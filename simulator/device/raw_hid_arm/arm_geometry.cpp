#include "simulator/device/raw_hid_arm/arm_geometry.h"

#include <algorithm>
#include <cmath>

#include "simulator/base/elementary.h"
#include "simulator/base/units.h"

namespace hallux::simulator {

namespace {

const Vec3 up_of_arm{0.0, 0.0, 1.0}, right_of_arm{0.0, 1.0, 0.0}, out_of_arm{1.0, 0.0, 0.0};

/// The arm's own axes are out to the person, right, up.
Vec3 in_device(const Vec3& in_arm) noexcept { return {in_arm.y, in_arm.z, in_arm.x}; }
Vec3 in_arm(const Vec3& in_device) noexcept { return {in_device.z, in_device.x, in_device.y}; }

struct Sines {
  double sine = 0.0, cosine = 1.0;

  explicit Sines(double angle_rad) noexcept
      : sine(elementary::sin(angle_rad)), cosine(elementary::cos(angle_rad)) {}
};

double encoder_rad(const ArmGeometry& geometry, const ArmCounts& counts,
                   std::size_t encoder) noexcept {
  return geometry.direction[encoder] * 2.0 * pi * static_cast<double>(counts[encoder]) /
         geometry.counts_per_turn[encoder];
}

/// Joint A turns what stands out from its axis.
double reach_mm(const ArmGeometry& geometry, const Sines& b, const Sines& c) noexcept {
  return geometry.first_mm * b.sine + geometry.second_mm * c.sine;
}

Quat grip_rotation(const ArmGeometry& geometry, const JointAngles& angles,
                   const ArmCounts& counts) noexcept {
  const auto gimbal_rad = [&](std::size_t from_device) {
    return encoder_rad(geometry, counts, arm_motors + from_device);
  };
  // The device names the gimbal's encoders from the grip inwards.
  return rotation_about(up_of_arm, angles[0]) * rotation_about(right_of_arm, 0.5 * pi - angles[2]) *
         rotation_about(out_of_arm, gimbal_rad(2)) * rotation_about(right_of_arm, gimbal_rad(1)) *
         rotation_about(out_of_arm, gimbal_rad(0));
}

template <std::size_t Count>
bool are_above_0(const std::array<double, Count>& values) noexcept {
  return std::all_of(values.begin(), values.end(),
                     [](double value) { return value > 0.0 && std::isfinite(value); });
}

}  // namespace

std::string fault_in(const ArmGeometry& geometry) {
  if (!are_above_0(std::array{geometry.base_mm, geometry.first_mm, geometry.second_mm}))
    return "a link has no length";
  if (!are_above_0(std::array{geometry.capstan_mm}) || !are_above_0(geometry.sector_mm))
    return "a drum or a sector has no size";
  if (!are_above_0(geometry.counts_per_turn)) return "an encoder has no counts";
  for (const double direction : geometry.direction)
    if (std::abs(direction) != 1.0) return "a direction is neither 1 nor -1";
  if (!are_above_0(geometry.torque_newton_mm_per_ampere) ||
      !are_above_0(std::array{geometry.current_ampere}))
    return "a motor has no torque or no current";
  if (!are_above_0(std::array{geometry.force_newton, geometry.continuous_force_newton,
                              geometry.stiffness_newton_per_mm, geometry.workspace_radius_mm}))
    return "force, stiffness and workspace must be above 0";
  if (!(geometry.damping_newton_s_per_mm >= 0.0)) return "damping must be at least 0";
  if (geometry.continuous_force_newton > geometry.force_newton)
    return "its motors cannot bear for ever more than they give";
  if (!is_finite(geometry.middle_mm)) return "its middle is no place";
  return {};
}

JointAngles joint_angles(const ArmGeometry& geometry, const ArmCounts& counts) noexcept {
  JointAngles angles{};
  for (std::size_t joint = 0; joint < arm_motors; ++joint) {
    angles[joint] =
        encoder_rad(geometry, counts, joint) * geometry.capstan_mm / geometry.sector_mm[joint];
  }
  return angles;
}

RigidTransform grip_pose(const ArmGeometry& geometry, const ArmCounts& counts) noexcept {
  const JointAngles angles = joint_angles(geometry, counts);
  const Sines a(angles[0]), b(angles[1]), c(angles[2]);
  const double reach = reach_mm(geometry, b, c);
  const Vec3 place_mm{
      a.cosine * reach, a.sine * reach,
      geometry.base_mm + geometry.first_mm * b.cosine - geometry.second_mm * c.cosine};
  const Quat turn = grip_rotation(geometry, angles, counts);
  // The same turn about the device's names of the axes.
  const Vec3 axis = in_device({turn.x, turn.y, turn.z});
  return {normalised({turn.w, axis.x, axis.y, axis.z}), in_device(place_mm - geometry.middle_mm)};
}

MotorCurrents motor_currents(const ArmGeometry& geometry, const ArmCounts& counts,
                             const Vec3& force_newton) noexcept {
  const JointAngles angles = joint_angles(geometry, counts);
  const Sines a(angles[0]), b(angles[1]), c(angles[2]);
  const double reach = reach_mm(geometry, b, c);
  const Vec3 force = in_arm(force_newton);
  const double out_newton = a.cosine * force.x + a.sine * force.y;
  const double aside_newton = a.cosine * force.y - a.sine * force.x;
  const std::array<double, arm_motors> torque_newton_mm{
      reach * aside_newton, geometry.first_mm * (b.cosine * out_newton - b.sine * force.z),
      geometry.second_mm * (c.cosine * out_newton + c.sine * force.z)};
  MotorCurrents currents{};
  double greatest_ampere = 0.0;
  for (std::size_t joint = 0; joint < arm_motors; ++joint) {
    currents[joint] = geometry.direction[joint] * torque_newton_mm[joint] * geometry.capstan_mm /
                      geometry.sector_mm[joint] / geometry.torque_newton_mm_per_ampere[joint];
    greatest_ampere = std::max(greatest_ampere, std::abs(currents[joint]));
  }
  if (greatest_ampere > geometry.current_ampere) {
    for (double& current : currents) current *= geometry.current_ampere / greatest_ampere;
  }
  return currents;
}

}  // namespace hallux::simulator
