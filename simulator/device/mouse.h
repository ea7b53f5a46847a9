/// The mouse as a device: a pointer leads a hand through a virtual coupling, so that steps of the
/// pointer become motion.
///
///     window: pointer, wheel, right drag --> target
///                                              | latest value
///     haptic:                                target --spring, damper--> hand of 0.15 kg
///                                                                        ^ simulated force
///
/// A mouse pushes nobody back. The hand in the middle does feel the force, so bone stops it and the
/// pointer runs ahead: how far it is ahead is how hard one pushes. Where no target comes any more,
/// because the window hangs or is minimised, nobody holds the saw: it stops. On a rail (rail.h) the
/// hand gives way in the rail's plane only.
#pragma once

#include "simulator/device/steered_device.h"
#include "simulator/record/latest.h"

namespace hallux::simulator {

/// source  docs/haptics.md, The mouse
struct MouseCoupling {
  double stiffness_newton_per_mm = 1.0;
  double mass_kg = 0.15;
  /// Critical: 2 sqrt(stiffness x mass).
  double damping_newton_s_per_mm = 0.0245;
  double speed_limit_mm_s = 800.0;
  /// In which a turn of the target is followed to 63 %.
  double turn_s = 0.03;
};

/// What the person did with the pointer since the frame before.
struct PointerMotion {
  /// To the right and up in the view plane, in the world's millimetres.
  Vec2 across_mm{0.0, 0.0};
  /// Away from the person.
  double deeper_mm = 0.0;
  /// Along the blade, from handle to teeth.
  double pushed_mm = 0.0;
  /// Of a drag: to the right about the view's y, up about its x.
  Vec2 turned_rad{0.0, 0.0};
  /// About the view's z, counter-clockwise as it is seen.
  double rolled_rad = 0.0;
  /// Shift: a fifth of all of it.
  bool is_fine = false;
};
inline constexpr double fine_share = 0.2;

/// The target after that motion, seen by one whose view has these axes (x right, y up, z to the
/// person). It turns about the middle of the tooth line.
RigidTransform steered(const RigidTransform& world_from_target, const Quat& world_from_view,
                       const PointerMotion& motion);
/// Kept within a ball of `radius_mm`, so that nobody loses the saw behind the picture's edge.
RigidTransform kept_within(const RigidTransform& world_from_target, const Vec3& middle_in_world_mm,
                           double radius_mm) noexcept;

class MouseDevice final : public SteeredDevice {
 public:
  explicit MouseDevice(const RigidTransform& world_from_start, const MouseCoupling& coupling = {});

  void aim(const Aim& aim) noexcept override;

  DeviceDescription description() const override { return {"Mouse and keyboard", "mouse"}; }
  bool exchange(const Vec3& force_in_world_newton, std::int64_t tick,
                RawDeviceState& state) noexcept override;

 private:
  void pull_towards(const Aim& aim, const Vec3& force_newton) noexcept;

  struct Target {
    Aim aim;
    /// Counts the calls of aim().
    std::uint64_t number = 0;
  };

  MouseCoupling coupling_;
  Latest<Target> target_;
  /// The window's.
  std::uint64_t aims_ = 0;
  /// The number that was heard last.
  std::uint64_t heard_ = 0;
  std::int64_t heard_tick_ = 0;
  RigidTransform world_from_hand_;
  Vec3 velocity_mm_s_{0.0, 0.0, 0.0};
  /// Of the last exchange.
  std::int64_t tick_ = -1;
};

}  // namespace hallux::simulator
