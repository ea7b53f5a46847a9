/// Devices of a port as the loop has them: an arm whose grip is the saw's, and a 3D mouse that
/// leads a hand. Inside this corner only.
///
///     port --place of the grip--> placing --> saw        arm: force back, turned into its frame
///          --deflection--> rate control --> coupled hand --> saw        3D mouse: nobody is pushed
///     window --target: how it is turned, switches--> both
///
/// Both take over where the saw is: nothing jumps when they begin, after a loss, or when the hand
/// was lifted.
#pragma once

#include <atomic>

#include "simulator/device/coupled_hand.h"
#include "simulator/device/placing.h"
#include "simulator/device/port/port.h"
#include "simulator/device/rate_control.h"
#include "simulator/device/steered_device.h"
#include "simulator/device/switch_board.h"
#include "simulator/record/latest.h"

namespace hallux::simulator {

/// What a window says, and whether it still does.
class HeardAim {
 public:
  explicit HeardAim(const SteeredDevice::Aim& first) : slot_({first, 0}) {}

  /// thread  window
  void write(const SteeredDevice::Aim& aim) noexcept { slot_.write({aim, ++said_}); }
  /// thread  haptic
  const SteeredDevice::Aim& read(std::int64_t tick) noexcept;
  /// Something was said, and then nothing for silence_ticks: nobody looks any more.
  bool is_silent(std::int64_t tick) const noexcept {
    return heard_ != 0 && tick - heard_tick_ > SteeredDevice::silence_ticks;
  }

 private:
  struct Said {
    SteeredDevice::Aim aim;
    /// Counts what was said.
    std::uint64_t number = 0;
  };

  Latest<Said> slot_;
  /// The window's.
  std::uint64_t said_ = 0;
  std::uint64_t heard_ = 0;
  std::int64_t heard_tick_ = 0;
};

/// What a device of a port reads before each exchange; the port may become another one's meanwhile.
class HeardPort {
 public:
  HeardPort(Port& port, const SteeredDevice::Aim& first) : port_(&port), aim_(first) {}

  struct Heard {
    Port& port;
    const PortState& said;
    const SteeredDevice::Aim& aim;
    /// Since the last exchange.
    std::int64_t ticks = 0;
  };

  /// thread  haptic
  Heard hear(std::int64_t tick) noexcept;
  /// The window that led it says nothing any more.
  bool is_silent(std::int64_t tick) const noexcept { return aim_.is_silent(tick); }
  /// The old port outlives the device.
  /// thread  any
  void go_on_with(Port& port) noexcept { port_.store(&port, std::memory_order_release); }
  /// thread  window
  void aim(const SteeredDevice::Aim& aim) noexcept { aim_.write(aim); }

 private:
  std::atomic<Port*> port_;
  HeardAim aim_;
  std::int64_t tick_ = -1;
};

struct PortDeviceSetup {
  /// Where the saw is when it begins.
  RigidTransform world_from_start;
  PlacingFrame frame = {};
  ButtonMap buttons = {};
  /// Of the force that the device gives, at most.
  double force_share = 1.0;
};

class ArmDevice final : public SteeredDevice {
 public:
  /// Borrows the port, which runs.
  ArmDevice(Port& port, const PortDeviceSetup& setup);

  /// Goes on with another port of the same device, which was away: softly, from where the saw is.
  /// The old one outlives the device.
  /// thread  any
  void go_on_with(Port& port) noexcept { port_.go_on_with(port); }
  void aim(const Aim& aim) noexcept override { port_.aim(aim); }
  Led led() const noexcept override { return turns_ ? Led::Nothing : Led::Rotation; }
  DeviceDescription description() const override;
  bool exchange(const Vec3& force_in_world_newton, std::int64_t tick,
                RawDeviceState& state) noexcept override;

 private:
  RigidTransform device_from_hand(const DriverState& said) const noexcept;
  void place(const DriverState& said, const Aim& aim, std::int64_t ticks) noexcept;

  HeardPort port_;
  PortDeviceSetup setup_;
  DeviceDescription described_;
  /// Its grip has a rotation of its own.
  bool turns_;
  Placing placing_;
  SwitchBoard switches_;
  RigidTransform world_from_saw_;
  /// With which it was exchanged last; nullptr: it begins, or was gone.
  Port* held_by_ = nullptr;
};

class RateDevice final : public SteeredDevice {
 public:
  /// Borrows the port, which runs.
  RateDevice(Port& port, const PortDeviceSetup& setup);

  /// thread  any
  void go_on_with(Port& port) noexcept { port_.go_on_with(port); }
  void aim(const Aim& aim) noexcept override { port_.aim(aim); }
  Led led() const noexcept override { return Led::Nothing; }
  DeviceDescription description() const override;
  bool exchange(const Vec3& force_in_world_newton, std::int64_t tick,
                RawDeviceState& state) noexcept override;

 private:
  HeardPort port_;
  DeviceDescription described_;
  RateControl control_;
  CoupledHand hand_;
  SwitchBoard switches_;
};

}  // namespace hallux::simulator
