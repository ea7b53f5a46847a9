/// What a bus answers to a read or a write. Inside this corner only.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace hallux::simulator {

enum class BusAnswer : std::uint8_t {
  Done,
  /// Nothing came, or nothing went, in time.
  Nothing,
  /// The device is not there any more.
  Gone,
  /// Another error: what the device or the system would not do.
  Refused
};

struct BusRead {
  BusAnswer answer = BusAnswer::Nothing;
  /// That were read.
  std::size_t bytes = 0;
};

/// A device as it is plugged in.
struct PluggedDevice {
  std::uint16_t vendor = 0, product = 0;
  std::string serial, product_name;
  /// Of the system's file that stands for it.
  std::string node;
  /// Of the socket that it is in; the same as long as it stays in it.
  std::string bus_path;

  friend bool operator==(const PluggedDevice&, const PluggedDevice&) = default;
};

}  // namespace hallux::simulator
