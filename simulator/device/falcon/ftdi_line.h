/// The serial line behind the Falcon's USB bridge (FTDI): settings by number, and bytes without the
/// bridge's own. Inside this corner only.
#pragma once

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <initializer_list>
#include <span>

#include "simulator/device/bus/usb_channel.h"

namespace hallux::simulator {

/// What the bridge is told.
struct FtdiSetting {
  std::uint8_t request = 0;
  std::uint16_t value = 0;
};
inline constexpr FtdiSetting purge_received{0, 1}, purge_sent{0, 2};
inline constexpr FtdiSetting ready_low{1, 0x0200}, terminal_low{1, 0x0100},
    terminal_high{1, 0x0101};
inline constexpr FtdiSetting no_flow_control{2, 0};
inline constexpr FtdiSetting baud_9600{3, 0x4138}, baud_boot{3, 0x0015}, baud_run{3, 0x0002};
inline constexpr FtdiSetting eight_bits{4, 0x0008};
/// How long the bridge waits for more before it sends [ms].
inline constexpr FtdiSetting latency_boot{9, 16}, latency_run{9, 1};

/// The bridge's status comes before what it has to say, in each packet.
inline constexpr std::size_t ftdi_status_bytes = 2;
inline std::span<const std::uint8_t> ftdi_payload(std::span<const std::uint8_t> packet) noexcept {
  return packet.subspan(std::min(ftdi_status_bytes, packet.size()));
}

/// All of them, until one is not done.
BusAnswer configure(UsbChannel& channel, std::initializer_list<FtdiSetting> settings) noexcept;

/// Waits until the bytes are on their way.
/// needs   at most usb_packet_bytes
BusAnswer send(UsbChannel& channel, std::span<const std::uint8_t> bytes) noexcept;

/// Bytes as they came in, at most so many; Nothing where fewer came in time.
BusAnswer receive(UsbChannel& channel, std::span<std::uint8_t> bytes,
                  std::chrono::milliseconds wait) noexcept;

}  // namespace hallux::simulator
