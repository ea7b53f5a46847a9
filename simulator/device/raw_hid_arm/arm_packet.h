/// The reports of the open serial arm's board: 64 bytes each way over raw HID, in strict turn.
/// Inside this corner only.
///
///     board: encoders a, b, c, d, e, f, a word of its own    int16, lowest byte first, then zeros
///     host:  currents a, b, c [mA], what to do, three words of it
///
/// The button comes as 10,000 on top of encoder d.
/// source  docs/haptics.md, Devices
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "simulator/device/raw_hid_arm/arm_geometry.h"

namespace hallux::simulator {

inline constexpr std::size_t arm_report_bytes = 64;
/// As the library takes it: the number 0 of a report that has none comes first.
inline constexpr std::size_t arm_output_bytes = arm_report_bytes + 1;

using ArmOutput = std::array<std::uint8_t, arm_output_bytes>;

struct ArmReport {
  ArmCounts counts{};
  bool is_pressed = false;

  friend bool operator==(const ArmReport&, const ArmReport&) = default;
};

/// Nothing where it has another length.
std::optional<ArmReport> arm_report(std::span<const std::uint8_t> bytes) noexcept;

/// Currents [A] to the motors; none beyond what a word holds.
ArmOutput arm_currents(const MotorCurrents& currents_ampere) noexcept;
/// From now on the encoders count from there; the motors are given nothing.
ArmOutput arm_encoders_set(const ArmCounts& counts) noexcept;

}  // namespace hallux::simulator
