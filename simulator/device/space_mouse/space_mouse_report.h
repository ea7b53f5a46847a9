/// What a 3D mouse of the SpaceMouse family reports: its cap's deflection along and about three
/// axes, and its buttons. Inside this corner only.
///
/// | report | bytes | what |
/// |---|---|---|
/// | 1 | 7 or 13 | x, y, z, and in the longer one the turns about them |
/// | 2 | 7 | the turns |
/// | 3 | 2 to 7 | a bit each button |
///
/// Newer ones send the longer report 1 and no report 2: what came is told by its length.
/// source  docs/haptics.md, Devices
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "simulator/device/port/device_driver.h"

namespace hallux::simulator {

/// On and off.
using SpaceMouseLight = std::array<std::uint8_t, 2>;
inline constexpr SpaceMouseLight space_mouse_light_on{0x04, 0x01},
    space_mouse_light_off{0x04, 0x00};

/// As the device counts: x right, y to the person, z down.
struct SpaceMouseState {
  std::array<std::int32_t, 3> pushed{}, turned{};
  /// Bit 0 is the first button.
  std::uint32_t buttons = 0;

  friend bool operator==(const SpaceMouseState&, const SpaceMouseState&) = default;
};

/// What a report was about.
enum class SpaceMouseNews { None, Motion, Buttons, Garbled };

/// Takes over what a report says; reports of other numbers say nothing to us.
/// errors  none: total, allocates nothing
SpaceMouseNews take_report(SpaceMouseState& state, std::span<const std::uint8_t> report) noexcept;

/// How far the cap is deflected.
/// needs   axis_limit > 0
Deflection deflection_of(const SpaceMouseState& state, std::int32_t axis_limit) noexcept;

}  // namespace hallux::simulator
