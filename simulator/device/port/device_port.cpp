#include "simulator/device/port/device_port.h"

#include <exception>
#include <utility>

namespace hallux::simulator {

namespace {

using Clock = std::chrono::steady_clock;

/// Percentiles are looked up once in so many exchanges.
constexpr std::uint64_t exchanges_per_look = 100;

}  // namespace

DevicePort::DevicePort(std::unique_ptr<DeviceDriver> driver)
    : driver_(std::move(driver)), description_(driver_->description()) {
  thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

DevicePort::~DevicePort() = default;

void DevicePort::say(const Vec3& force_in_device_newton) noexcept {
  said_.write({force_in_device_newton, ++number_});
}

TroubleReport DevicePort::trouble() const {
  const std::lock_guard lock(mutex_);
  const bool is_slow = !trouble_ && is_slow_.load(std::memory_order_relaxed);
  return is_slow ? TroubleReport{DeviceTrouble::TooSlow, {}, {}} : trouble_;
}

DeviceDescription DevicePort::description() const {
  const std::lock_guard lock(mutex_);
  return description_;
}

PortFigures DevicePort::figures() const {
  const std::lock_guard lock(mutex_);
  return figures_;
}

void DevicePort::run(const std::stop_token& stop) noexcept {
  try {
    TroubleReport report = open(stop);
    if (!report && !stop.stop_requested()) talk(stop);
    if (report) end(report);
  } catch (const std::exception& error) {
    end({DeviceTrouble::SystemRefused, {}, error.what()});
  }
  driver_->close();
  phase_.store(PortPhase::Ended, std::memory_order_release);
}

TroubleReport DevicePort::open(const std::stop_token& stop) {
  TroubleReport report = driver_->open([&](PortPhase phase, double fraction) {
    PortState state;
    state.phase = phase;
    state.fraction = fraction;
    publish(state);
    return !stop.stop_requested();
  });
  const std::lock_guard lock(mutex_);
  if (!report) description_ = driver_->description();
  return report;
}

void DevicePort::talk(const std::stop_token& stop) {
  PortCycle cycle(*driver_, Clock::now());
  while (!stop.stop_requested() && !cycle.is_over()) {
    cycle.run(said_.read(), Clock::now);
    publish(cycle.state());
    note(cycle.statistics(), cycle.state().said);
  }
  if (cycle.is_over()) end({cycle.state().trouble, {}, {}});
}

void DevicePort::publish(const PortState& state) noexcept {
  state_.write(state);
  is_slow_.store(state.trouble == DeviceTrouble::TooSlow, std::memory_order_relaxed);
  phase_.store(state.phase, std::memory_order_release);
}

void DevicePort::note(const PortStatistics& statistics, const DriverState& said) {
  const std::lock_guard lock(mutex_);
  figures_.exchanges = statistics.exchanges;
  figures_.packets = statistics.packets;
  figures_.bad_packets = statistics.bad_packets;
  figures_.late_packets = statistics.late_packets;
  figures_.zeros = statistics.zeros;
  figures_.pushes_unanswered = statistics.pushes_unanswered;
  figures_.greatest_force_newton = statistics.greatest_force_newton;
  if (statistics.calibrated_for)
    figures_.calibration_age_s = std::chrono::duration<double>(*statistics.calibrated_for).count();
  figures_.own_force_scale = said.own_force_scale;
  figures_.round_trip_max_us = statistics.round_trips.greatest_us();
  if (statistics.exchanges % exchanges_per_look != 0) return;
  figures_.round_trip_p50_us = statistics.round_trips.at_us(0.5);
  figures_.round_trip_p99_us = statistics.round_trips.at_us(0.99);
}

void DevicePort::end(const TroubleReport& report) noexcept {
  PortState state;
  state.phase = PortPhase::Ended;
  state.trouble = report.trouble;
  {
    const std::lock_guard lock(mutex_);
    trouble_ = report;
  }
  publish(state);
}

}  // namespace hallux::simulator
