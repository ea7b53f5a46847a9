/// What a HID device says about its reports, as far as we ask: what it is and how far its axes
/// reach. Inside this corner only.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

namespace hallux::simulator {

/// HID's names of what a device is for.
struct HidUsage {
  std::uint16_t page = 0, usage = 0;

  friend bool operator==(const HidUsage&, const HidUsage&) = default;
};
/// Generic desktop, multi-axis controller.
inline constexpr HidUsage multi_axis_controller{0x01, 0x08};

/// The greatest value of its axes X to Rz; the least of them, where they differ. Nothing where it
/// has no axis.
/// errors  none: total; a descriptor that breaks off says what came before
std::optional<std::int32_t> axis_limit_in(std::span<const std::uint8_t> descriptor) noexcept;

}  // namespace hallux::simulator
