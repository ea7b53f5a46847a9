#include "simulator/device/port/device_trouble.h"

#include <array>

namespace hallux::simulator {

std::string_view id_of(DeviceTrouble trouble) noexcept {
  // In the order of the enumeration.
  static constexpr std::array<std::string_view, 19> ids{
      "none",        "no_permission",   "busy",           "no_firmware",   "bad_firmware",
      "wrong_echo",  "not_homed",       "not_calibrated", "no_service",    "service_version",
      "wrong_model", "closed_protocol", "bad_record",     "too_slow",      "unplugged",
      "silent",      "garbled",         "service_gone",   "system_refused"};
  static_assert(ids.size() == static_cast<std::size_t>(DeviceTrouble::SystemRefused) + 1);
  return ids[static_cast<std::size_t>(trouble)];
}

}  // namespace hallux::simulator
