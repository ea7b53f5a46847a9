/// HID devices as computations: reports in, reports out.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <functional>
#include <span>
#include <vector>

namespace hallux::tests {

/// Reports as a device makes and takes them.
class HidModel {
 public:
  virtual ~HidModel() = default;
  /// False: the device refuses it.
  virtual bool receive(std::span<const std::uint8_t> report) = 0;

  bool has_news() const noexcept { return !reports_.empty(); }
  std::size_t waiting() const noexcept { return reports_.size(); }
  std::vector<std::uint8_t> take() {
    std::vector<std::uint8_t> report = std::move(reports_.front());
    reports_.pop_front();
    return report;
  }
  void say(std::vector<std::uint8_t> report) { reports_.push_back(std::move(report)); }

 private:
  std::deque<std::vector<std::uint8_t>> reports_;
};

/// A 3D mouse; older ones say their turns in a report of their own.
class SpaceMouseModel final : public HidModel {
 public:
  bool receive(std::span<const std::uint8_t> report) override;
  void push(const std::array<int, 3>& pushed, const std::array<int, 3>& turned);
  void press(std::uint8_t buttons) { say({3, buttons, 0}); }

  bool is_older = false;
  /// On and off, as it was told.
  std::vector<bool> lights;
};

/// The board of the open serial arm: each report it is sent is answered by one.
class ArmModel final : public HidModel {
 public:
  bool receive(std::span<const std::uint8_t> report) override;

  std::array<std::int16_t, 6> encoders{};
  std::array<std::int16_t, 3> currents_ma{};
  bool is_pressed = false;
  bool is_silent = false;
  /// Of its answers; another is none of its own.
  std::size_t report_bytes = 64;
  std::uint64_t reports = 0;
  /// Before each answer.
  std::function<void(ArmModel&)> on_report;
};

}  // namespace hallux::tests
