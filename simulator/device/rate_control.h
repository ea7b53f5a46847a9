/// What a device that is deflected and springs back makes of the hand: the further its cap is
/// pushed, the faster the hand goes. Inside this corner only.
#pragma once

#include "simulator/base/transform.h"
#include "simulator/device/port/device_driver.h"

namespace hallux::simulator {

/// source  docs/haptics.md, Devices: ours, after what drivers of such devices do
struct RateSettings {
  /// Of the greatest deflection, in which nothing moves.
  double dead_share = 8.0 / 350.0;
  double speed_mm_s = 150.0, turn_rad_s = 1.5;
  /// In which a change is followed to 63 %.
  double smoothing_s = 0.05;
};

/// Which share of the greatest speed a deflection asks for: nothing in the dead zone, gently near
/// it.
Vec3 rate_response(const Vec3& shares, double dead_share) noexcept;

class RateControl {
 public:
  explicit RateControl(const RigidTransform& world_from_hand, const RateSettings& settings = {})
      : settings_(settings), world_from_hand_(world_from_hand) {}

  const RigidTransform& world_from_hand() const noexcept { return world_from_hand_; }
  void put(const RigidTransform& world_from_hand) noexcept { world_from_hand_ = world_from_hand; }

  /// One tick with that deflection, by one who looks so (x right, y up, z to the person). The hand
  /// turns about the tool's own place.
  void advance(const Deflection& deflection, const Quat& world_from_view) noexcept;

 private:
  RateSettings settings_;
  RigidTransform world_from_hand_;
  /// In the view, smoothed.
  Vec3 velocity_mm_s_{0.0, 0.0, 0.0}, turn_rad_s_{0.0, 0.0, 0.0};
};

}  // namespace hallux::simulator
