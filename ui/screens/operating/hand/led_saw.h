/// The saw as a person leads it: its target and its switches, told to the device that is steered.
///
///     pointer, keys --> hand --placing--> target --rail, reach--> device
///     device held by a hand --> loop --seen--> target
///
/// A lifted hand moves without the saw. On a rail the target is kept in a plane. Where a device has
/// a hand of its own, the window leads the rest (SteeredDevice::Led), and the saw is where the loop
/// says.
#pragma once

#include <optional>
#include <span>

#include "simulator/device/mouse.h"
#include "simulator/device/placing.h"
#include "simulator/device/rail.h"
#include "simulator/device/steered_device.h"
#include "simulator/record/record.h"

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
        seen_{world_from_start, 0},
        site_in_world_mm_(site_in_world_mm) {
    placing_.set_down(hand_, world_from_target_);
  }

  const RigidTransform& world_from_target() const noexcept { return world_from_target_; }
  bool is_on() const noexcept { return has(switches(), simulator::Switch::SawRuns); }
  bool is_irrigated() const noexcept { return has(switches(), simulator::Switch::Irrigates); }
  /// What of it the window leads.
  simulator::SteeredDevice::Led led() const noexcept {
    return device_ == nullptr ? simulator::SteeredDevice::Led::Pose : device_->led();
  }
  /// All of it.
  bool is_led_by_window() const noexcept { return led() == simulator::SteeredDevice::Led::Pose; }
  /// The hand moves without the saw.
  bool is_lifted() const noexcept { return placing_.is_lifted(); }
  /// Whether the device has heard nothing for so long that it stops the saw by itself.
  bool is_silent(double now_s) const noexcept;

  /// Steers that device from now on; borrowed.
  void take(simulator::SteeredDevice& device) noexcept { device_ = &device; }
  void set_on(bool is_on) noexcept { order(simulator::Switch::SawRuns, is_on); }
  void set_irrigated(bool is_irrigated) noexcept {
    order(simulator::Switch::Irrigates, is_irrigated);
  }
  /// Where the loop has put the saw, and what runs: of a device that a hand holds.
  void see(const RigidTransform& world_from_tool, std::uint32_t switches) noexcept {
    seen_ = {world_from_tool, switches};
  }
  /// Mouse and keys lead from where the saw is, in place of the device that was lost.
  /// needs   a device was taken
  void take_over();
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
  /// As the loop said it last.
  struct Seen {
    RigidTransform world_from_tool;
    /// Bits of Switch.
    std::uint32_t switches = 0;
  };

  /// Of a device with buttons of its own what they made of it.
  std::uint32_t switches() const noexcept { return is_led_by_window() ? ordered_ : seen_.switches; }
  void order(simulator::Switch which, bool is_on) noexcept;
  /// Where the person's hands want it.
  RigidTransform wanted() noexcept;
  RigidTransform bounded(const RigidTransform& world_from_target, double duration_s) const noexcept;
  void tell(std::uint32_t switches) const noexcept;

  simulator::SteeredDevice* device_ = nullptr;
  /// Of the pointer, in the world's millimetres; only its way means anything.
  RigidTransform hand_;
  simulator::Placing placing_;
  std::optional<simulator::Rail> rail_;
  RigidTransform world_from_target_;
  Quat world_from_view_{1.0, 0.0, 0.0, 0.0};
  Seen seen_;
  Vec3 site_in_world_mm_{0.0, 0.0, 0.0};
  /// Bits of Switch as the window wants them, and how often it wanted anything.
  std::uint32_t ordered_ = 0, orders_ = 0;
  bool is_released_ = false;
  double led_s_ = 0.0;
};

}  // namespace hallux::ui
