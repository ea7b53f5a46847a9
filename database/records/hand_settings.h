/// How a person holds the saw, as it is kept of them. Inside this room only.
#pragma once

#include <cstdint>
#include <optional>

namespace hallux::database {

inline constexpr std::int32_t motion_scale_milli_least = 250, motion_scale_milli_most = 4000;

struct HandSettings {
  bool is_left_handed = false;
  /// Millimetres of the saw for a thousand of the hand; none: as it is set for the station.
  std::optional<std::int32_t> motion_scale_milli = std::nullopt;
  /// Thousandths of the device's force that are felt at most; none: as it is set for the station,
  /// which is never exceeded.
  std::optional<std::int32_t> force_share_milli = std::nullopt;

  friend bool operator==(const HandSettings&, const HandSettings&) = default;
};

}  // namespace hallux::database
