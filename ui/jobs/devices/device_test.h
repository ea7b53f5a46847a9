/// A device opened, homed and exchanged with, to see how it fares.
#pragma once

#include <optional>
#include <string>

#include "simulator/base/progress.h"
#include "simulator/device/station/station.h"

namespace hallux::ui {

/// For somebody to take the grip and bring it home.
inline constexpr double homed_within_s = 60.0;

struct DeviceTest {
  double home_within_s = homed_within_s;
  /// Of exchanges, once it is homed.
  double seconds = 2.0;
  /// Of a wall through the place where the grip is after homing, felt from both sides; none: no
  /// force at all.
  std::optional<double> wall_newton_per_mm = std::nullopt;
};

struct DeviceTestResult {
  simulator::PortFigures figures;
  /// What the device said, a second.
  double rate_hz = 0.0;
  bool is_homed = false;
  /// Why it failed; none: it did not.
  simulator::TroubleReport fault;
  /// Forces of zero after the fault, or at the end.
  std::uint64_t zero_after_packets = 0;
};

/// Waits until a device that is being opened runs: somebody takes its grip and brings it home.
/// False where that takes too long, or it is gone.
/// errors  Cancelled
bool is_brought_home(simulator::DevicePort& port, double within_s, const Progress& progress);

/// Of a device that was not: some must be homed, some calibrated.
simulator::DeviceTrouble trouble_of_homing(simulator::DeviceKind kind) noexcept;

/// needs   the station lists the device as usable
/// errors  Cancelled
DeviceTestResult test_device(simulator::Station& station, const std::string& id,
                             const DeviceTest& wanted, const Progress& progress);

}  // namespace hallux::ui
