/// The saw as a person leads it: its target and its switches, told to the device that is steered.
///
///     pointer, keys --> hand --placing--> target --rail, reach--> device
///
/// A lifted hand moves without the saw. On a rail the target is kept in a plane.
#pragma once

#include <optional>
#include <span>

#include "simulator/device/mouse.h"
#include "simulator/device/placing.h"
#include "simulator/device/rail.h"
#include "simulator/device/steered_device.h"

namespace hallux::ui {

class LedSaw {
 public:
  /// How far from the site the saw may be led.
  static constexpr double reach_mm = 90.0;

  LedSaw() = default;
  /// world_from_start  pose in which the device holds the saw
  /// site_in_world_mm  middle of what is operated on
  LedSaw(const RigidTransform& world_from_start, const Vec3& site_in_world_mm)
      : hand_(world_from_start),
        world_from_target_(world_from_start),
        site_in_world_mm_(site_in_world_mm) {
    placing_.set_down(hand_, world_from_target_);
  }

  const RigidTransform& world_from_target() const noexcept { return world_from_target_; }
  bool is_on() const noexcept { return is_on_; }
  bool is_irrigated() const noexcept { return is_irrigated_; }
  /// The hand moves without the saw.
  bool is_lifted() const noexcept { return placing_.is_lifted(); }
  /// Whether the device has heard nothing for so long that it stops the saw by itself.
  bool is_silent(double now_s) const noexcept;

  /// Steers that device from now on; borrowed.
  void take(simulator::SteeredDevice& device) noexcept { device_ = &device; }
  void set_on(bool is_on) noexcept { is_on_ = is_on; }
  void set_irrigated(bool is_irrigated) noexcept { is_irrigated_ = is_irrigated; }
  void lift() noexcept { placing_.lift(); }
  /// The hand is on the saw again, where both are.
  void set_down() noexcept { placing_.set_down(hand_, world_from_target_); }
  /// The plane in which the saw is kept from now on; nothing: none.
  void set_rail(const std::optional<simulator::Rail>& rail) noexcept { rail_ = rail; }
  /// Moves the hand, the target after it, and tells the device; once a frame, also without motion,
  /// while anybody leads.
  /// world_from_view  axes of the person's view: x right, y up, z to the person
  /// needs   a device was taken
  void lead(std::span<const simulator::PointerMotion> motions, const Quat& world_from_view,
            double now_s) noexcept;
  /// Nobody holds it: it stands still with every switch off.
  /// needs   a device was taken
  void release() noexcept;

 private:
  RigidTransform bounded(const RigidTransform& world_from_target, double duration_s) const noexcept;
  void tell(std::uint32_t switches) const noexcept;

  simulator::SteeredDevice* device_ = nullptr;
  /// Of the pointer, in the world's millimetres; only its way means anything.
  RigidTransform hand_;
  simulator::Placing placing_;
  std::optional<simulator::Rail> rail_;
  RigidTransform world_from_target_;
  Vec3 site_in_world_mm_{0.0, 0.0, 0.0};
  bool is_on_ = false, is_irrigated_ = false;
  double led_s_ = 0.0;
};

}  // namespace hallux::ui
