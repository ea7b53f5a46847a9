/// One exchange of a port after the other, in whatever time its caller has: the port's thread in
/// real time, a test in virtual time. Inside this corner only.
///
/// It knows when a device is silent, garbled or too slow; what a driver says itself is believed.
///
/// | the device | is given | is |
/// |---|---|---|
/// | has said nothing for 4 of its periods, 4 ms at least | zero | running |
/// | for 200 ms | zero | lost: silent |
/// | has said 20 things in a row that are none of its packets | zero | lost: garbled |
/// | answers later than 3 ms, as a rule | zero | running, too slow for a force |
#pragma once

#include <cstdint>
#include <optional>

#include "simulator/base/time_spread.h"
#include "simulator/device/port/dead_man_switch.h"
#include "simulator/device/port/device_driver.h"

namespace hallux::simulator {

/// What a port tells, made for one slot.
struct PortState {
  PortPhase phase = PortPhase::Opening;
  /// Where it ended: why. While it runs: TooSlow, or none.
  DeviceTrouble trouble = DeviceTrouble::None;
  /// Of the opening's phase [0, 1].
  double fraction = 0.0;
  DriverState said;
  /// Counts what the device said.
  std::uint64_t packet = 0;
};

struct PortStatistics {
  std::uint64_t exchanges = 0, packets = 0, bad_packets = 0, late_packets = 0;
  /// Forces of zero since the device's fault, or since nobody says one any more.
  std::uint64_t zeros = 0;
  /// Forces above zero that it was given since it answered last.
  std::uint64_t pushes_unanswered = 0;
  double greatest_force_newton = 0.0;
  /// Of what the device answered.
  TimeSpread round_trips;
  /// Since it was seen to come home.
  std::optional<std::chrono::microseconds> calibrated_for = std::nullopt;
};

class PortCycle {
 public:
  using Time = DeadManSwitch::Time;

  /// Of an opened driver, which outlives it.
  PortCycle(DeviceDriver& driver, Time now);

  /// Exchanges once. `read_clock` is asked before and after.
  template <typename ReadClock>
  void run(const SaidForce& newest, ReadClock&& read_clock) noexcept {
    const Time before = read_clock();
    const Vec3 force_newton = force_for(newest, before);
    const DriverExchange exchange = driver_.exchange(force_newton);
    const bool is_pushed = force_newton != Vec3(0.0, 0.0, 0.0);
    if (exchange.answer == DriverAnswer::Said)
      statistics_.pushes_unanswered = 0;
    else
      statistics_.pushes_unanswered += is_pushed ? 1 : 0;
    judge(exchange, before, read_clock());
  }

  const PortState& state() const noexcept { return state_; }
  const PortStatistics& statistics() const noexcept { return statistics_; }
  bool is_over() const noexcept { return state_.phase == PortPhase::Ended; }

 private:
  Vec3 force_for(const SaidForce& newest, Time now) noexcept;
  void judge(const DriverExchange& exchange, Time before, Time after) noexcept;
  void take(const DriverExchange& exchange, Time before, Time after) noexcept;
  void end(DeviceTrouble trouble) noexcept;
  std::chrono::microseconds period() const noexcept;

  DeviceDriver& driver_;
  DevicePulse pulse_;
  bool has_motors_;
  DeadManSwitch guard_;
  PortState state_;
  PortStatistics statistics_;
  /// When it said something last, and when it was not at home last, if it ever was not.
  Time heard_;
  std::optional<Time> away_at_;
  std::uint32_t garbled_in_a_row_ = 0;
};

}  // namespace hallux::simulator
