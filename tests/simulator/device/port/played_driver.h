/// A driver that answers what a test says, in virtual time.
#pragma once

#include <deque>
#include <vector>

#include "simulator/device/port/device_driver.h"

namespace hallux::simulator {

struct PlayedAnswer {
  DriverExchange exchange;
  std::chrono::microseconds takes{1000};
};

class PlayedDriver final : public DeviceDriver {
 public:
  TroubleReport open(const OpeningWatch& watch) override {
    if (!watch(PortPhase::Loading, 0.5)) return {};
    is_open = !opening;
    return opening;
  }
  DeviceDescription description() const override { return described; }
  DriverExchange exchange(const Vec3& force_in_device_newton) noexcept override {
    forces_newton.push_back(force_in_device_newton);
    const PlayedAnswer answer = answers.empty() ? otherwise : answers.front();
    if (!answers.empty()) answers.pop_front();
    now += answer.takes;
    return answer.exchange;
  }
  void close() noexcept override { is_open = false; }

  DeviceDescription described{"played", "arm3", DeviceLimits{.force_newton = 8.0},
                              DevicePulse{.numbers_packets = true}};
  TroubleReport opening;
  /// What it says first, and then for ever.
  std::deque<PlayedAnswer> answers;
  PlayedAnswer otherwise{{DriverAnswer::Said, {}, DeviceTrouble::None}};
  std::vector<Vec3> forces_newton;
  std::chrono::steady_clock::time_point now{};
  bool is_open = false;
};

}  // namespace hallux::simulator
