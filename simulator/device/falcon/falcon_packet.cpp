#include "simulator/device/falcon/falcon_packet.h"

#include <algorithm>

namespace hallux::simulator {

namespace {

constexpr std::uint8_t start = '<', end = '>', zero = 'A';
constexpr std::size_t first_value = 1, nibbles = 4, switches = 13, unused = 14;
/// The highest that a byte of a value and that of the switches say.
constexpr std::uint8_t nibble_most = 0x0F, switches_most = 0x7F;
constexpr std::uint8_t homing_bit = 1;

void put(FalconPacket& packet, std::size_t at, std::int32_t value) noexcept {
  const auto bits = static_cast<std::uint16_t>(value);
  for (std::size_t i = 0; i < nibbles; ++i) {
    packet[at + i] = static_cast<std::uint8_t>(zero + ((bits >> (4U * i)) & nibble_most));
  }
}

/// Nothing where a byte says no nibble.
std::optional<std::int32_t> value_at(std::span<const std::uint8_t, falcon_packet_bytes> bytes,
                                     std::size_t at) noexcept {
  unsigned bits = 0;
  for (std::size_t i = 0; i < nibbles; ++i) {
    const auto nibble = static_cast<std::uint8_t>(bytes[at + i] - zero);
    if (nibble > nibble_most) return std::nullopt;
    bits |= static_cast<unsigned>(nibble) << (4U * i);
  }
  return static_cast<std::int16_t>(bits);
}

}  // namespace

FalconPacket encoded(const FalconCommand& command) noexcept {
  FalconPacket packet{};
  packet.front() = start;
  packet.back() = end;
  for (std::size_t leg = 0; leg < falcon_legs; ++leg) {
    put(packet, first_value + nibbles * leg,
        std::clamp(command.motors[leg], -falcon_motor_counts, falcon_motor_counts));
  }
  const int bits = (command.is_homing ? homing_bit : 0) | command.lights;
  packet[switches] = static_cast<std::uint8_t>(zero + bits);
  packet[unused] = zero;
  return packet;
}

std::optional<FalconReport> decoded(
    std::span<const std::uint8_t, falcon_packet_bytes> bytes) noexcept {
  const auto bits = static_cast<std::uint8_t>(bytes[switches] - zero);
  if (bytes.front() != start || bytes.back() != end || bits > switches_most) return std::nullopt;
  FalconReport report;
  for (std::size_t leg = 0; leg < falcon_legs; ++leg) {
    const std::optional<std::int32_t> value = value_at(bytes, first_value + nibbles * leg);
    if (!value) return std::nullopt;
    report.encoders[leg] = *value;
    report.homed[leg] = (bits >> (4U + leg) & 1U) != 0;
  }
  report.buttons = bits & nibble_most;
  return report;
}

std::optional<FalconReport> FalconReports::take(std::span<const std::uint8_t> bytes) noexcept {
  std::optional<FalconReport> newest;
  for (const std::uint8_t byte : bytes) {
    if (size_ == 0 && byte != start) {
      if (!is_astray_) ++bad_;
      is_astray_ = true;
      continue;
    }
    begun_[size_++] = byte;
    if (size_ < begun_.size()) continue;
    const std::optional<FalconReport> report = decoded(begun_);
    is_astray_ = !report;
    if (report) {
      newest = report;
      ++count_;
      size_ = 0;
    } else {
      ++bad_;
      drop_to_next_start();
    }
  }
  return newest;
}

/// What began as a packet was none; one may have begun within it.
void FalconReports::drop_to_next_start() noexcept {
  const auto next = std::find(begun_.begin() + 1, begun_.end(), start);
  size_ = static_cast<std::size_t>(begun_.end() - next);
  std::move(next, begun_.end(), begun_.begin());
}

}  // namespace hallux::simulator
