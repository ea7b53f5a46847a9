#include "simulator/device/port/port_cycle.h"

#include <algorithm>

namespace hallux::simulator {

namespace {

constexpr std::chrono::milliseconds lost_after{200}, hushed_at_least{4};
constexpr int hushed_periods = 4;
constexpr std::uint32_t garbled_at_most = 20;
/// A device is judged by so many answers, again and again.
constexpr std::uint64_t answers_judged = 200;
constexpr double slow_above_us = 3000.0;

}  // namespace

PortCycle::PortCycle(DeviceDriver& driver, Time now)
    : driver_(driver),
      pulse_(driver.description().pulse),
      has_motors_(driver.description().limits.has_value()),
      heard_(now) {
  state_.phase = PortPhase::Homing;
}

std::chrono::microseconds PortCycle::period() const noexcept {
  return std::chrono::milliseconds(pulse_.period_ticks);
}

Vec3 PortCycle::force_for(const SaidForce& newest, Time now) noexcept {
  const auto patience =
      std::max<std::chrono::microseconds>(hushed_at_least, hushed_periods * period());
  const bool is_hushed = pulse_.numbers_packets && now - heard_ > patience;
  const bool may_push =
      state_.phase == PortPhase::Running && !is_hushed && state_.trouble == DeviceTrouble::None;
  const Vec3 force_newton = guard_.allowed(newest, now, may_push);
  statistics_.zeros = guard_.is_released() ? statistics_.zeros + 1 : 0;
  statistics_.greatest_force_newton =
      std::max(statistics_.greatest_force_newton, length_of(force_newton));
  return force_newton;
}

void PortCycle::judge(const DriverExchange& exchange, Time before, Time after) noexcept {
  ++statistics_.exchanges;
  if (exchange.answer == DriverAnswer::Gone) return end(exchange.trouble);
  if (exchange.answer == DriverAnswer::Said) return take(exchange, before, after);
  if (exchange.answer == DriverAnswer::Garbled) {
    ++statistics_.bad_packets;
    if (++garbled_in_a_row_ >= garbled_at_most) return end(DeviceTrouble::Garbled);
  }
  if (pulse_.numbers_packets && after - heard_ > lost_after) end(DeviceTrouble::Silent);
}

void PortCycle::take(const DriverExchange& exchange, Time before, Time after) noexcept {
  garbled_in_a_row_ = 0;
  if (pulse_.numbers_packets && after - heard_ > 2 * period()) ++statistics_.late_packets;
  heard_ = after;
  statistics_.round_trips.add(after - before);
  state_.packet = ++statistics_.packets;
  state_.said = exchange.state;
  state_.phase = exchange.state.is_homed ? PortPhase::Running : PortPhase::Homing;
  if (state_.phase == PortPhase::Homing) away_at_ = after;
  if (away_at_) {
    statistics_.calibrated_for =
        std::chrono::duration_cast<std::chrono::microseconds>(after - *away_at_);
  }
  if (has_motors_ && statistics_.packets % answers_judged == 0) {
    const bool is_slow = statistics_.round_trips.at_us(0.5) > slow_above_us;
    state_.trouble = is_slow ? DeviceTrouble::TooSlow : DeviceTrouble::None;
  }
}

void PortCycle::end(DeviceTrouble trouble) noexcept {
  state_.phase = PortPhase::Ended;
  state_.trouble = trouble;
}

}  // namespace hallux::simulator
