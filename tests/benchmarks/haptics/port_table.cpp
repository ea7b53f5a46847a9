// What a device behind its port costs: the loop's exchange, how soon a force is with the driver,
// the share of a core, memory, and one message of an Inverse3's service.
//
//     port_table [--out DIR]
//
// Tables are printed as Markdown and written as CSV. The driver is one that waits for its
// millisecond as a bus does and says a place; no library and no device is measured.
#include <malloc.h>

#include <atomic>
#include <filesystem>
#include <iostream>
#include <string>
#include <thread>

#include "simulator/device/inverse3/inverse_message.h"
#include "simulator/device/port/device_port.h"
#include "simulator/device/port_device.h"
#include "tests/benchmarks/report/percentiles.h"
#include "tests/benchmarks/report/table.h"
#include "tests/benchmarks/report/table_program.h"

namespace hallux::benchmarks {

namespace {

using namespace simulator;
using Clock = std::chrono::steady_clock;

/// Says a place every `period`; 0: as often as it is asked. Notes when a push upwards came.
class TimedDriver final : public DeviceDriver {
 public:
  TimedDriver(std::chrono::microseconds period, std::atomic<Clock::rep>& came_at)
      : period_(period), came_at_(came_at) {}

  TroubleReport open(const OpeningWatch&) override {
    next_ = Clock::now();
    return {};
  }
  DeviceDescription description() const override {
    return {.name = "timed",
            .device_class = "arm3",
            .limits = DeviceLimits{.force_newton = 8.0},
            .pulse = DevicePulse{.numbers_packets = true}};
  }
  DriverExchange exchange(const Vec3& force_newton) noexcept override {
    if (force_newton.y > 0.0 && came_at_.load() == 0)
      came_at_.store(Clock::now().time_since_epoch().count());
    next_ = std::max(next_ + period_, Clock::now());
    if (period_.count() > 0) std::this_thread::sleep_until(next_);
    DriverExchange said{DriverAnswer::Said, {}, DeviceTrouble::None};
    said.state.device_from_handle.translation_mm.x = 0.01 * static_cast<double>(++count_ % 100);
    return said;
  }
  void close() noexcept override {}

 private:
  std::chrono::microseconds period_;
  std::atomic<Clock::rep>& came_at_;
  Clock::time_point next_;
  std::int64_t count_ = 0;
};

constexpr std::chrono::milliseconds tick{1};
std::atomic<Clock::rep> nobody_asks{1};

std::unique_ptr<DevicePort> running_port(std::chrono::microseconds period,
                                         std::atomic<Clock::rep>& came_at = nobody_asks) {
  auto port = std::make_unique<DevicePort>(std::make_unique<TimedDriver>(period, came_at));
  while (port->phase() != PortPhase::Running) std::this_thread::sleep_for(tick);
  return port;
}

std::vector<Cell> row_of(const char* what, const std::vector<double>& values) {
  const Percentiles spread = percentiles_of(values);
  return {what, spread.median, spread.p99, spread.greatest};
}

/// A hundred thousand, one each 20 us: the port is between two slots meanwhile.
std::vector<double> exchanges_us() {
  const std::unique_ptr<DevicePort> port = running_port(tick);
  ArmDevice arm(*port, PortDeviceSetup{});
  RawDeviceState state;
  std::vector<double> times_us(100'000);
  for (std::size_t i = 0; i < times_us.size(); ++i) {
    const auto begun = Clock::now();
    arm.exchange({0.0, 1.0, 0.0}, static_cast<std::int64_t>(i), state);
    const auto ended = Clock::now();
    times_us[i] = std::chrono::duration<double, std::micro>(ended - begun).count();
    while (Clock::now() - begun < std::chrono::microseconds(20)) {
    }
  }
  return times_us;
}

/// From the loop's word to the driver's hand, a thousand times, while a hand is pushed.
std::vector<double> force_to_packet_us() {
  std::atomic<Clock::rep> came_at{1};
  const std::unique_ptr<DevicePort> port = running_port(tick, came_at);
  const auto push_down_for = [&](std::chrono::microseconds time) {
    for (const auto end = Clock::now() + time; Clock::now() < end;) {
      port->say({0.0, -8.0, 0.0});
      std::this_thread::sleep_for(std::chrono::microseconds(100));
    }
  };
  push_down_for(std::chrono::seconds(1));
  std::vector<double> times_us;
  for (int i = 0; i < 1000; ++i) {
    // Odd against the device's period.
    push_down_for(std::chrono::microseconds(3000 + 37 * (i % 27)));
    came_at.store(0);
    const auto said = Clock::now();
    port->say({0.0, 8.0, 0.0});
    while (came_at.load() == 0) std::this_thread::sleep_for(std::chrono::microseconds(50));
    const Clock::time_point came{Clock::duration(came_at.load())};
    times_us.push_back(std::chrono::duration<double, std::micro>(came - said).count());
  }
  return times_us;
}

std::vector<double> messages_us() {
  const std::string state =
      R"({"inverse3":[{"device_id":"049D","state":{"cursor_position":{"x":0.01,"y":-0.12,)"
      R"("z":0.15},"cursor_velocity":{"x":0,"y":0,"z":0},"current_cursor_force":{"x":0.5,)"
      R"("y":0,"z":-1}},"status":{"calibrated":true}}],"wireless_verse_grip":[{"device_id":)"
      R"("61576","state":{"orientation":{"w":1,"x":0,"y":0,"z":0},)"
      R"("buttons":{"a":false,"b":false,"c":false}}}]})";
  std::vector<double> times_us(20'000);
  for (double& time_us : times_us) {
    const auto begun = Clock::now();
    const auto message = inverse_message(state);
    time_us = std::chrono::duration<double, std::micro>(Clock::now() - begun).count();
    if (!message || message->arm_count != 1) throw std::runtime_error("the state was not read");
  }
  return times_us;
}

Table times() {
  return {.name = "port_times",
          .title = "A device behind its port",
          .columns = {"what", "p50 us", "p99 us", "greatest us"},
          .rows = {row_of("exchange of the loop", exchanges_us()),
                   row_of("force said until the driver has it", force_to_packet_us()),
                   row_of("a state of the Inverse3's service, read", messages_us())},
          .notes = {"driver at 1 kHz"}};
}

double heap_kib() { return static_cast<double>(::mallinfo2().uordblks) / 1024.0; }

Table cost() {
  constexpr double measured_s = 5.0;
  const double before_kib = heap_kib();
  const std::unique_ptr<DevicePort> paced = running_port(tick);
  const double one_kib = heap_kib() - before_kib;
  const Stopwatch watch;
  std::this_thread::sleep_for(std::chrono::duration<double>(measured_s));
  const double share = watch.worked_milliseconds() / watch.milliseconds();
  constexpr std::uint64_t wanted = 3'600'000;
  const std::unique_ptr<DevicePort> fast = running_port(std::chrono::microseconds{0});
  while (fast->figures().exchanges < wanted / 100) std::this_thread::sleep_for(tick);
  const double begun_kib = heap_kib();
  while (fast->figures().exchanges < wanted) std::this_thread::sleep_for(tick);
  const double grown_kib = heap_kib() - begun_kib;
  if (grown_kib > 1.0) throw std::runtime_error("a port took memory while it was exchanged with");
  return {.name = "port_cost",
          .title = "What a device at 1 kHz takes",
          .columns = {"share of a core %", "memory KiB", "grown in 3.6 million exchanges KiB"},
          .rows = {{100.0 * share, one_kib, grown_kib}},
          .notes = {}};
}

void run(const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  for (const Table& table : {times(), cost()}) {
    print_table(std::cout, table);
    write_csv(folder, table);
  }
  std::cout << "\ncalibration: " << calibration_ms() << " ms\nCSV: " << folder.string() << '\n';
}

}  // namespace

}  // namespace hallux::benchmarks

int main(int count, char** words) {
  return hallux::benchmarks::table_program(count, words, "port_table", HALLUX_RESULTS,
                                           hallux::benchmarks::run);
}
