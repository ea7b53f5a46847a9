/// Reports to and from an opened HID device. Inside this corner only.
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <span>

#include "simulator/device/bus/bus_answer.h"
#include "simulator/device/port/device_trouble.h"

namespace hallux::simulator {

class HidChannel {
 public:
  virtual ~HidChannel() = default;

  /// One output report, its number first (0 where it has none).
  virtual BusAnswer write(std::span<const std::uint8_t> report) noexcept = 0;
  /// One input report, however long; waits for it so long.
  virtual BusRead read(std::span<std::uint8_t> report, std::chrono::milliseconds wait) noexcept = 0;
};

struct OpenedHid {
  /// None where there was a trouble.
  std::unique_ptr<HidChannel> channel;
  TroubleReport trouble;
};

}  // namespace hallux::simulator
