/// The mouse as a device: a pointer leads a hand through a virtual coupling, so that steps of the
/// pointer become motion.
///
///     window: pointer, wheel, right drag --> target
///                                              | latest value
///     haptic:                                target --> coupled hand --> saw
///
/// A mouse pushes nobody back: the hand in the middle (coupled_hand.h) feels the force. Where no
/// target comes any more, because the window hangs or is minimised, nobody holds the saw: it stops.
/// On a rail (rail.h) the hand gives way in the rail's plane only.
#pragma once

#include "simulator/device/coupled_hand.h"
#include "simulator/device/steered_device.h"
#include "simulator/record/latest.h"

namespace hallux::simulator {

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
  explicit MouseDevice(const RigidTransform& world_from_start, const HandCoupling& coupling = {});

  void aim(const Aim& aim) noexcept override;

  DeviceDescription description() const override { return {"Mouse and keyboard", "mouse"}; }
  bool exchange(const Vec3& force_in_world_newton, std::int64_t tick,
                RawDeviceState& state) noexcept override;

 private:
  struct Target {
    Aim aim;
    /// Counts the calls of aim().
    std::uint64_t number = 0;
  };

  CoupledHand hand_;
  Latest<Target> target_;
  /// The window's.
  std::uint64_t aims_ = 0;
  /// The number that was heard last.
  std::uint64_t heard_ = 0;
  std::int64_t heard_tick_ = 0;
  /// Of the last exchange.
  std::int64_t tick_ = -1;
};

}  // namespace hallux::simulator
