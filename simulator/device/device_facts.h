/// What an attempt's certificate says of the device that it was operated with.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace hallux::simulator {

/// What a port has seen so far, in figures.
struct PortFigures {
  std::uint64_t exchanges = 0, packets = 0, bad_packets = 0, late_packets = 0;
  /// Forces of zero since the device's fault, or since nobody says one any more.
  std::uint64_t zeros = 0;
  /// Forces above zero that the device was given since it answered last.
  std::uint64_t pushes_unanswered = 0;
  double greatest_force_newton = 0.0;
  double round_trip_p50_us = 0.0, round_trip_p99_us = 0.0, round_trip_max_us = 0.0;
  /// Since somebody brought it home; nothing: it was before it was opened, or it needs none.
  std::optional<double> calibration_age_s = std::nullopt;
  /// Newtons that the device says it gives for one that it was told; nothing: it says none.
  std::optional<double> own_force_scale = std::nullopt;

  friend bool operator==(const PortFigures&, const PortFigures&) = default;
};

struct DeviceFacts {
  /// The kind's id, the device's own name, its class, and through which library it was reached.
  std::string kind, model, device_class, library;
  double motion_scale = 1.0;
  PortFigures figures;

  friend bool operator==(const DeviceFacts&, const DeviceFacts&) = default;
};

}  // namespace hallux::simulator
