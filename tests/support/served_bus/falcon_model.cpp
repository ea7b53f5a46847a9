#include "tests/support/served_bus/falcon_model.h"

#include <algorithm>

namespace hallux::tests {

namespace {

constexpr std::size_t packet_bytes = 16, bridge_payload = 62;
constexpr std::size_t head_bytes = 22, block_head_bytes = 6;
constexpr std::uint8_t zero = 'A';

}  // namespace

bool FalconModel::request(std::uint8_t number, std::uint16_t value) {
  constexpr std::uint16_t tells_terminal = 0x0100, boot_baud = 0x15, run_baud = 0x02;
  switch (number) {
    case 0:
      if (value == 1) to_send_.clear();
      return true;
    case 1: {
      if ((value & tells_terminal) == 0) return true;
      const bool is_high = (value & 1U) != 0;
      if (is_high && !is_terminal_high_) {
        mode_ = Mode::BootCalled;
        was_called_ = is_loaded_ = false;
        line_.clear();
      }
      is_terminal_high_ = is_high;
      return true;
    }
    case 3:
      if (value == boot_baud && mode_ == Mode::BootCalled && was_called_)
        mode_ = Mode::BootListening;
      if (value == run_baud && is_loaded_) mode_ = Mode::Runs;
      line_.clear();
      return true;
    case 9:
      latency_ms_ = value & 0xFF;
      return true;
    case 2:
    case 4:
      return true;
    default:
      return false;
  }
}

void FalconModel::receive(std::span<const std::uint8_t> bytes) {
  for (const std::uint8_t byte : bytes) take(byte);
}

std::vector<std::uint8_t> FalconModel::packet() {
  std::vector<std::uint8_t> bytes{0x01, 0x60};
  for (std::size_t i = 0; i < bridge_payload && !to_send_.empty(); ++i) {
    bytes.push_back(to_send_.front());
    to_send_.pop_front();
  }
  return bytes;
}

void FalconModel::take(std::uint8_t byte) {
  if (mode_ == Mode::Off) return;
  if (mode_ != Mode::Runs) return take_boot_byte(byte);
  if (line_.empty() && byte != '<') return;
  line_.push_back(byte);
  if (line_.size() < packet_bytes) return;
  answer();
  line_.clear();
}

void FalconModel::take_boot_byte(std::uint8_t byte) {
  if (mode_ == Mode::BootCalled) {
    line_.push_back(byte);
    if (byte != 0x0D) return;
    was_called_ = line_ == std::vector<std::uint8_t>{0x0A, 0x43, 0x0D};
    if (was_called_) say(std::array<std::uint8_t, 4>{0x0A, 0x44, 0x2C, 0x0D});
    line_.clear();
    return;
  }
  if (mode_ == Mode::BootListening) {
    say(std::array{byte});
    if (byte != 'A') return;
    mode_ = Mode::BootLoading;
    image_bytes_ = block_left_ = 0;
    head_.clear();
    return;
  }
  take_image_byte(byte);
}

void FalconModel::take_image_byte(std::uint8_t byte) {
  ++image_bytes_;
  const bool is_wrong = faults.wrong_echo_at == image_bytes_ && faults.failing_loads > 0;
  if (is_wrong) --faults.failing_loads;
  say(std::array{static_cast<std::uint8_t>(is_wrong ? byte ^ 0xFFU : byte)});
  if (image_bytes_ <= head_bytes || is_loaded_) return;
  if (block_left_ > 0) {
    --block_left_;
    return;
  }
  head_.push_back(byte);
  if (head_.size() == 2 && head_[0] == 0 && head_[1] == 0) is_loaded_ = true;
  if (head_.size() < block_head_bytes) return;
  block_left_ = 2U * (head_[0] | static_cast<std::size_t>(head_[1]) << 8U);
  head_.clear();
}

void FalconModel::answer() {
  if (line_.back() != '>') return;
  for (std::size_t leg = 0; leg < 3; ++leg) {
    unsigned bits = 0;
    for (std::size_t i = 0; i < 4; ++i)
      bits |= static_cast<unsigned>(line_[1 + 4 * leg + i] - zero) << (4 * i);
    motors_[leg] = static_cast<std::int16_t>(bits);
  }
  lights_ = static_cast<std::uint8_t>((line_[13] - zero) & 0x0E);
  ++packets_;
  if (on_packet) on_packet(*this);
  if (faults.is_silent) return;
  std::array<std::uint8_t, packet_bytes> reply{};
  reply.front() = '<';
  reply.back() = '>';
  for (std::size_t leg = 0; leg < 3; ++leg) {
    for (std::size_t i = 0; i < 4; ++i) {
      const auto bits = static_cast<std::uint16_t>(encoders[leg]);
      reply[1 + 4 * leg + i] = static_cast<std::uint8_t>(zero + ((bits >> (4 * i)) & 0xFU));
    }
  }
  reply[13] = static_cast<std::uint8_t>(zero + ((is_homed ? 7 : 0) << 4 | (buttons & 0xF)));
  reply[14] = zero;
  if (faults.is_garbled) std::reverse(reply.begin(), reply.end());
  say(reply);
  if (faults.is_long) say(std::array<std::uint8_t, 200>{});
}

void FalconModel::say(std::span<const std::uint8_t> bytes) {
  to_send_.insert(to_send_.end(), bytes.begin(), bytes.end());
}

std::vector<std::uint8_t> some_firmware(std::size_t words) {
  std::vector<std::uint8_t> image{0xAA, 0x08};
  image.resize(head_bytes, 0);
  image.push_back(static_cast<std::uint8_t>(words & 0xFFU));
  image.push_back(static_cast<std::uint8_t>(words >> 8U));
  image.resize(image.size() + 4, 0);
  for (std::size_t i = 0; i < 2 * words; ++i) image.push_back(static_cast<std::uint8_t>(i * 31U));
  image.resize(image.size() + 2, 0);
  return image;
}

}  // namespace hallux::tests
