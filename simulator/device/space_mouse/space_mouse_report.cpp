#include "simulator/device/space_mouse/space_mouse_report.h"

#include <algorithm>

namespace hallux::simulator {

namespace {

constexpr std::size_t short_bytes = 7, long_bytes = 13, buttons_bytes_most = 7;
constexpr std::size_t buttons_told = 4;

void take_axes(std::array<std::int32_t, 3>& axes, std::span<const std::uint8_t> bytes) noexcept {
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const auto low = static_cast<unsigned>(bytes[2 * i]),
               high = static_cast<unsigned>(bytes[2 * i + 1]);
    axes[i] = static_cast<std::int16_t>(low | high << 8U);
  }
}

SpaceMouseNews take_pushed(SpaceMouseState& state, std::span<const std::uint8_t> report) noexcept {
  if (report.size() != short_bytes && report.size() != long_bytes) return SpaceMouseNews::Garbled;
  take_axes(state.pushed, report.subspan(1));
  if (report.size() == long_bytes) take_axes(state.turned, report.subspan(short_bytes));
  return SpaceMouseNews::Motion;
}

SpaceMouseNews take_turned(SpaceMouseState& state, std::span<const std::uint8_t> report) noexcept {
  if (report.size() != short_bytes) return SpaceMouseNews::Garbled;
  take_axes(state.turned, report.subspan(1));
  return SpaceMouseNews::Motion;
}

SpaceMouseNews take_buttons(SpaceMouseState& state, std::span<const std::uint8_t> report) noexcept {
  if (report.size() < 2 || report.size() > buttons_bytes_most) return SpaceMouseNews::Garbled;
  state.buttons = 0;
  for (std::size_t i = 1; i < report.size() && i <= buttons_told; ++i) {
    state.buttons |= static_cast<std::uint32_t>(report[i]) << (8U * (i - 1));
  }
  return SpaceMouseNews::Buttons;
}

Vec3 share_of(const std::array<std::int32_t, 3>& axes, std::int32_t axis_limit) noexcept {
  const auto share = [&](std::int32_t value) {
    return std::clamp(static_cast<double>(value) / axis_limit, -1.0, 1.0);
  };
  return {share(axes[0]), -share(axes[2]), share(axes[1])};
}

}  // namespace

SpaceMouseNews take_report(SpaceMouseState& state, std::span<const std::uint8_t> report) noexcept {
  if (report.empty()) return SpaceMouseNews::Garbled;
  switch (report.front()) {
    case 1:
      return take_pushed(state, report);
    case 2:
      return take_turned(state, report);
    case 3:
      return take_buttons(state, report);
    default:
      return SpaceMouseNews::None;
  }
}

Deflection deflection_of(const SpaceMouseState& state, std::int32_t axis_limit) noexcept {
  return {share_of(state.pushed, axis_limit), share_of(state.turned, axis_limit)};
}

}  // namespace hallux::simulator
