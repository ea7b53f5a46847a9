/// Transfers to and from an opened USB device with one pipe each way. Inside this corner only.
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <span>

#include "simulator/device/bus/bus_answer.h"
#include "simulator/device/port/device_trouble.h"

namespace hallux::simulator {

/// The greatest that a device at full speed sends at once.
inline constexpr std::size_t usb_packet_bytes = 64;

class UsbChannel {
 public:
  virtual ~UsbChannel() = default;

  /// A vendor's request to the device, without data.
  virtual BusAnswer request(std::uint8_t number, std::uint16_t value) noexcept = 0;
  /// Goes out while its caller goes on; `bytes` are copied. Nothing where the one before has not
  /// gone out yet.
  /// needs   at most usb_packet_bytes
  virtual BusAnswer write(std::span<const std::uint8_t> bytes) noexcept = 0;
  /// One packet as it came, however long; waits for it so long.
  virtual BusRead read(std::span<std::uint8_t, usb_packet_bytes> packet,
                       std::chrono::milliseconds wait) noexcept = 0;
};

struct OpenedUsb {
  /// None where there was a trouble.
  std::unique_ptr<UsbChannel> channel;
  TroubleReport trouble;
};

}  // namespace hallux::simulator
