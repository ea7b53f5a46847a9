/// A Novint Falcon behind its USB bridge, as a computation: requests and bytes in, packets out. It
/// knows no transport, so that a test plays it directly and a served bus serves it.
///
/// It holds no firmware of anybody's: whatever boot stream it is sent makes it run.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <functional>
#include <span>
#include <vector>

namespace hallux::tests {

class FalconModel {
 public:
  enum class Mode { Off, BootCalled, BootListening, BootLoading, Runs };

  /// What a test makes go wrong.
  struct Faults {
    /// Counts the bytes of firmware; that one is echoed wrongly. 0: none.
    std::size_t wrong_echo_at = 0;
    /// So many loads fail, then none.
    int failing_loads = 1'000'000;
    bool is_silent = false;
    /// Answers with bytes that are no packet.
    bool is_garbled = false;
    /// Answers with more than a packet.
    bool is_long = false;
  };

  /// A vendor's request; false: the device stalls.
  bool request(std::uint8_t number, std::uint16_t value);
  void receive(std::span<const std::uint8_t> bytes);
  bool has_news() const noexcept { return !to_send_.empty(); }
  /// One packet of the bridge: two bytes of status, then what is to be sent.
  std::vector<std::uint8_t> packet();

  Mode mode() const noexcept { return mode_; }
  /// It was loaded before, and was not switched off since.
  void run() noexcept { mode_ = Mode::Runs; }

  std::uint64_t packets() const noexcept { return packets_; }
  const std::array<std::int32_t, 3>& motors() const noexcept { return motors_; }
  std::uint8_t lights() const noexcept { return lights_; }
  int latency_ms() const noexcept { return latency_ms_; }

  // What the hand does, and what goes wrong.
  std::array<std::int32_t, 3> encoders{};
  std::uint8_t buttons = 0;
  bool is_homed = false;
  /// Before each answer.
  std::function<void(FalconModel&)> on_packet;
  Faults faults;

 private:
  void take(std::uint8_t byte);
  void take_boot_byte(std::uint8_t byte);
  void take_image_byte(std::uint8_t byte);
  void answer();
  void say(std::span<const std::uint8_t> bytes);

  Mode mode_ = Mode::Off;
  bool is_terminal_high_ = false, was_called_ = false, is_loaded_ = false;
  int latency_ms_ = 16;
  std::vector<std::uint8_t> line_;
  std::deque<std::uint8_t> to_send_;
  /// Of the image, with what is left of the block at hand.
  std::size_t image_bytes_ = 0, block_left_ = 0;
  std::vector<std::uint8_t> head_;
  std::uint64_t packets_ = 0;
  std::array<std::int32_t, 3> motors_{};
  std::uint8_t lights_ = 0;
};

/// A boot stream of so many words that is nobody's firmware.
std::vector<std::uint8_t> some_firmware(std::size_t words = 3900);

}  // namespace hallux::tests
