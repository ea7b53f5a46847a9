#include "tests/support/served_bus/hid_models.h"

#include <algorithm>

namespace hallux::tests {

namespace {

void put(std::vector<std::uint8_t>& bytes, int value) {
  const auto bits = static_cast<std::uint16_t>(value);
  bytes.push_back(static_cast<std::uint8_t>(bits & 0xFFU));
  bytes.push_back(static_cast<std::uint8_t>(bits >> 8U));
}

}  // namespace

bool SpaceMouseModel::receive(std::span<const std::uint8_t> report) {
  if (report.size() != 2 || report[0] != 4) return false;
  lights.push_back(report[1] != 0);
  return true;
}

void SpaceMouseModel::push(const std::array<int, 3>& pushed, const std::array<int, 3>& turned) {
  std::vector<std::uint8_t> report{1};
  for (const int axis : pushed) put(report, axis);
  if (is_older) {
    say(std::move(report));
    report = {2};
  }
  for (const int axis : turned) put(report, axis);
  say(std::move(report));
}

bool ArmModel::receive(std::span<const std::uint8_t> report) {
  if (report.size() != 65 || report[0] != 0) return false;
  ++reports;
  std::array<std::int16_t, 7> words{};
  for (std::size_t i = 0; i < words.size(); ++i) {
    words[i] = static_cast<std::int16_t>(report[1 + 2 * i] | report[2 + 2 * i] << 8);
  }
  constexpr std::int16_t sets_encoders = 1;
  if (words[3] == sets_encoders) {
    std::copy_n(words.begin() + 4, 3, encoders.begin());
    std::copy_n(words.begin(), 3, encoders.begin() + 3);
    currents_ma = {};
  } else {
    std::copy_n(words.begin(), 3, currents_ma.begin());
  }
  if (on_report) on_report(*this);
  if (is_silent) return true;
  std::vector<std::uint8_t> answer;
  for (std::size_t i = 0; i < encoders.size(); ++i) {
    put(answer, encoders[i] + (i == 3 && is_pressed ? 10'000 : 0));
  }
  answer.resize(report_bytes, 0);
  say(std::move(answer));
  return true;
}

}  // namespace hallux::tests
