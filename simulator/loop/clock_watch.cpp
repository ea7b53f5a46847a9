#include "simulator/loop/clock_watch.h"

#include <ctime>

namespace hallux::simulator {

namespace {

constexpr std::chrono::milliseconds longest_reading{1}, least_step{10};

std::chrono::nanoseconds time_of(clockid_t clock) noexcept {
  timespec time{};
  ::clock_gettime(clock, &time);
  return std::chrono::seconds{time.tv_sec} + std::chrono::nanoseconds{time.tv_nsec};
}

}  // namespace

ClockReading read_clocks() noexcept {
  ClockReading reading;
  reading.paced_before = time_of(CLOCK_MONOTONIC);
  reading.machine = time_of(CLOCK_BOOTTIME);
  reading.paced_after = time_of(CLOCK_MONOTONIC);
  return reading;
}

void ClockWatch::observe(const ClockReading& reading) noexcept {
  if (reading.paced_after - reading.paced_before > longest_reading) return;
  const std::chrono::nanoseconds apart = reading.machine - reading.paced_before;
  if (apart_ && std::chrono::abs(apart - *apart_) > least_step) ++steps_;
  apart_ = apart;
}

}  // namespace hallux::simulator
