#include "simulator/device/raw_hid_arm/arm_packet.h"

#include <algorithm>

#include "simulator/base/units.h"

namespace hallux::simulator {

namespace {

constexpr std::size_t words = 7, word_bytes = 2;
constexpr std::size_t command_word = 3, attribute_word = 4, gimbal = arm_motors;
constexpr std::int32_t set_currents = 0, set_encoders = 1;
constexpr std::int32_t pressed_above = 5'000, pressed_adds = 10'000;
constexpr double milliampere_per_ampere = 1000.0;

using Words = std::array<std::int32_t, words>;

ArmOutput output_of(const Words& values) noexcept {
  ArmOutput bytes{};
  for (std::size_t i = 0; i < words; ++i) {
    const auto bits = static_cast<std::uint16_t>(std::clamp(values[i], INT16_MIN, INT16_MAX));
    bytes[1 + word_bytes * i] = static_cast<std::uint8_t>(bits & 0xFFU);
    bytes[2 + word_bytes * i] = static_cast<std::uint8_t>(bits >> 8U);
  }
  return bytes;
}

}  // namespace

std::optional<ArmReport> arm_report(std::span<const std::uint8_t> bytes) noexcept {
  if (bytes.size() != arm_report_bytes) return std::nullopt;
  ArmReport report;
  for (std::size_t i = 0; i < arm_encoders; ++i) {
    const auto low = static_cast<unsigned>(bytes[word_bytes * i]);
    const auto high = static_cast<unsigned>(bytes[word_bytes * i + 1]);
    report.counts[i] = static_cast<std::int16_t>(low | high << 8U);
  }
  report.is_pressed = report.counts[gimbal] > pressed_above;
  if (report.is_pressed) report.counts[gimbal] -= pressed_adds;
  return report;
}

ArmOutput arm_currents(const MotorCurrents& currents_ampere) noexcept {
  Words values{};
  for (std::size_t i = 0; i < arm_motors; ++i) {
    values[i] = round_to_int32(currents_ampere[i] * milliampere_per_ampere);
  }
  values[command_word] = set_currents;
  return output_of(values);
}

/// The gimbal's counts stand where the currents do otherwise.
ArmOutput arm_encoders_set(const ArmCounts& counts) noexcept {
  Words values{};
  std::copy_n(counts.begin() + gimbal, arm_motors, values.begin());
  values[command_word] = set_encoders;
  std::copy_n(counts.begin(), arm_motors, values.begin() + attribute_word);
  return output_of(values);
}

}  // namespace hallux::simulator
