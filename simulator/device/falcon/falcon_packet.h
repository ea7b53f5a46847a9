/// The packets of a Novint Falcon whose firmware runs: 16 bytes out, 16 bytes in; it answers only
/// when it was spoken to. Inside this corner only.
///
///     '<'  4 nibbles of each of three values, lowest first  switches  0  '>'      each as 'A' + n
///
/// source  docs/haptics.md, Devices
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "simulator/device/falcon/falcon_kinematics.h"

namespace hallux::simulator {

inline constexpr std::size_t falcon_packet_bytes = 16;
/// The motors' greatest, either way.
inline constexpr std::int32_t falcon_motor_counts = 4095;

using FalconPacket = std::array<std::uint8_t, falcon_packet_bytes>;

enum class FalconLight : std::uint8_t { Green = 2, Blue = 4, Red = 8 };

struct FalconCommand {
  FalconCounts motors{};
  /// Bits of FalconLight.
  std::uint8_t lights = 0;
  /// Else the device forgets where its legs are.
  bool is_homing = true;
};

/// Of a Falcon's grip, as its bits lie.
enum class FalconButton : std::uint8_t { Plus = 1, Forward = 2, Centre = 4, Minus = 8 };

struct FalconReport {
  FalconCounts encoders{};
  /// Bits of FalconButton.
  std::uint8_t buttons = 0;
  /// Of each leg, once it was pushed in to its stop.
  std::array<bool, falcon_legs> homed{};

  bool is_homed() const noexcept { return homed[0] && homed[1] && homed[2]; }
  friend bool operator==(const FalconReport&, const FalconReport&) = default;
};

/// needs   |motors| <= falcon_motor_counts
FalconPacket encoded(const FalconCommand& command) noexcept;
/// Nothing where it is no such packet.
std::optional<FalconReport> decoded(
    std::span<const std::uint8_t, falcon_packet_bytes> bytes) noexcept;

/// Finds reports in a stream of bytes, however it is cut into pieces.
class FalconReports {
 public:
  /// The newest whole report that ends in these bytes; what is no packet is passed over.
  /// errors  none: total, allocates nothing
  std::optional<FalconReport> take(std::span<const std::uint8_t> bytes) noexcept;

  /// That began as a packet and were none, and bytes between packets, each row of them once.
  std::uint64_t bad() const noexcept { return bad_; }
  /// Whole ones.
  std::uint64_t count() const noexcept { return count_; }

 private:
  void drop_to_next_start() noexcept;

  FalconPacket begun_{};
  std::size_t size_ = 0;
  /// What passes by belongs to no packet.
  bool is_astray_ = false;
  std::uint64_t bad_ = 0, count_ = 0;
};

}  // namespace hallux::simulator
