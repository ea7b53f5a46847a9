/// The proxy: the pose nearest to the hand's that bone allows, and the friction on the way there.
/// Inside this room only.
///
/// A god-object (Zilles and Salisbury 1995) with six degrees of freedom (Ortega, Redon and
/// Coquillart 2007) and several contacts. What is least is the work stored between hand and tool:
/// |way|^2 + grip^2 |turn|^2. Each contact gives a push along its normal and a hold across it of at
/// most friction times the push; both are said as millimetres of the coupling's stretch, so that
/// coupling x push is a force.
/// source  docs/haptics.md, Where the tool is
#pragma once

#include <array>
#include <span>

#include "simulator/contact/blade_contact.h"

namespace hallux::simulator {

/// A small rigid motion of the tool in the bone frame; the turn is about the tool's origin.
struct ProxyMotion {
  Vec3 translation_mm{0.0, 0.0, 0.0};
  Vec3 rotation_rad{0.0, 0.0, 0.0};
};

/// From one pose to another; exact for small turns, and the right way round for all.
ProxyMotion motion_between(const RigidTransform& from, const RigidTransform& to) noexcept;
RigidTransform moved_by(const RigidTransform& pose, const ProxyMotion& motion) noexcept;

struct ProxyFriction {
  /// A contact at rest slides where it is pulled by more than this share of the push.
  double static_friction = 0.3;
  /// Of it, once it slides.
  double kinetic_ratio = 0.6;
  /// As hold, of the teeth.
  double tooth_friction = 0.3;
};

/// What each point of the blade bears [mm of stretch], kept from tick to tick: the search goes on
/// from there.
struct ProxyLoad {
  std::array<double, contact_limit> normal_mm{};
  std::array<Vec3, contact_limit> tangential_mm{};
  bool slides = false;

  /// The point bears nothing.
  void forget(std::size_t point) noexcept {
    normal_mm[point] = 0.0;
    tangential_mm[point] = Vec3{0.0, 0.0, 0.0};
  }
};

struct ProxyResult {
  ProxyMotion motion;
  /// What the teeth bear of the stretch, on the tool.
  Vec3 tooth_mm{0.0, 0.0, 0.0};
  /// Of all contacts together.
  double normal_mm = 0.0;
};

/// The motion towards `wanted` that brings no contact's gap below zero; a face that is in by more
/// than a rounding is led out, a tooth is led no deeper.
/// needs   normals of unit length; grip_mm > 0
/// errors  none: total, allocates nothing, a bounded number of sweeps
/// thread  haptic
ProxyResult solve_proxy(const ProxyMotion& wanted, std::span<const BladeContact> contacts,
                        double grip_mm, const ProxyFriction& friction, ProxyLoad& load) noexcept;

}  // namespace hallux::simulator
