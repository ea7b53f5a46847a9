/// Placing of a hand in the world: where the tool stands for a pose of the device's handle. Its
/// clutch lifts the hand off the tool and sets it down elsewhere.
///
///     device            world
///     hand ---------->  tool                 engaged: the tool follows the hand's way, turned by
///       '--lifted--> hand, tool stays        the frame and scaled, from where it was set down
///
/// Setting down makes no jump, and lifting moves nothing.
#pragma once

#include "simulator/base/transform.h"

namespace hallux::simulator {

/// How a device's axes and millimetres lie in the world.
struct PlacingFrame {
  Quat world_from_device{1.0, 0.0, 0.0, 0.0};
  /// World millimetres for one of the device; above 0.
  double motion_scale = 1.0;
};

class Placing {
 public:
  Placing() = default;
  explicit Placing(const PlacingFrame& frame) : frame_(frame) {}

  bool is_lifted() const noexcept { return is_lifted_; }

  /// Sets the hand down on the tool: from now on the tool follows it.
  /// device_from_hand  where the handle is now
  /// world_from_tool   where the tool is now
  void set_down(const RigidTransform& device_from_hand,
                const RigidTransform& world_from_tool) noexcept;
  /// The tool stays where it is until the hand is set down again.
  void lift() noexcept { is_lifted_ = true; }

  /// Where the tool is for that handle; where it was set down last while lifted.
  RigidTransform place(const RigidTransform& device_from_hand) noexcept;

 private:
  PlacingFrame frame_;
  /// Of the moment in which the hand was set down.
  RigidTransform device_from_hand_, world_from_tool_;
  /// The last answer.
  RigidTransform placed_;
  bool is_lifted_ = false;
};

}  // namespace hallux::simulator
