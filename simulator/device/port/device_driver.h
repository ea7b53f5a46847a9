/// What a driver of a device is to its port: opened, exchanged with, closed, all on the port's
/// thread, where it may wait for the bus. Inside this corner only.
///
/// A driver is a state machine over a channel (simulator/device/bus): it names no library, so that
/// each of its faults can be played to it in virtual time.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "simulator/device/haptic_device.h"
#include "simulator/device/port/device_trouble.h"

namespace hallux::simulator {

/// Of a device that is deflected and springs back: each part in [-1, 1] of its greatest. Axes as of
/// every device: x right, y up, z to the person.
struct Deflection {
  Vec3 pushed{0.0, 0.0, 0.0}, turned{0.0, 0.0, 0.0};

  friend bool operator==(const Deflection&, const Deflection&) = default;
};

/// What a device said last.
struct DriverState {
  /// Frame of the device: x right, y up, z to the person, its origin in the middle of its
  /// workspace. A device that measures no rotation leaves it as it is.
  RigidTransform device_from_handle;
  Deflection deflection;
  /// Bit 0 is the first button.
  std::uint32_t buttons = 0;
  /// It knows where its legs are; a device that always knows is so.
  bool is_homed = true;
  /// Newtons that it says it gives for one that it was told; nothing: it says none.
  std::optional<double> own_force_scale = std::nullopt;
};

enum class DriverAnswer : std::uint8_t {
  /// A new state.
  Said,
  /// Nothing came in time.
  Nothing,
  /// Something that is none of its packets; the state is as before.
  Garbled,
  /// It is gone.
  Gone
};

struct DriverExchange {
  DriverAnswer answer = DriverAnswer::Nothing;
  /// As of the newest `Said`.
  DriverState state;
  /// Where it is gone: why.
  DeviceTrouble trouble = DeviceTrouble::None;
};

enum class PortPhase : std::uint8_t { Opening, Loading, Homing, Running, Ended };

/// Told how far the opening is [0, 1]; false: it shall stop.
using OpeningWatch = std::function<bool(PortPhase phase, double fraction)>;

class DeviceDriver {
 public:
  virtual ~DeviceDriver() = default;

  /// Brings it to where it can be exchanged with. A trouble leaves nothing open; stopped by the
  /// watch it has none and is not open.
  virtual TroubleReport open(const OpeningWatch& watch) = 0;
  /// After open: an arm's limits may be known only then.
  virtual DeviceDescription description() const = 0;
  /// Sends the force [N, frame of the device] and waits for what the device says to it, a period of
  /// the device at most.
  virtual DriverExchange exchange(const Vec3& force_in_device_newton) noexcept = 0;
  /// No force, said to the device where that is still possible; nothing is open after it.
  virtual void close() noexcept = 0;
};

}  // namespace hallux::simulator
