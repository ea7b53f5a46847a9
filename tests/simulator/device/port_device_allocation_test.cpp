#include <gtest/gtest.h>

#include <thread>

#include "simulator/device/port/device_port.h"
#include "simulator/device/port_device.h"
#include "tests/support/allocation_counter.h"

namespace hallux::simulator {
namespace {

constexpr std::int64_t exchanges = 100'000;

/// Answers after a while, somewhere else each time.
class QuietDriver final : public DeviceDriver {
 public:
  explicit QuietDriver(std::string device_class) : class_(std::move(device_class)) {}

  TroubleReport open(const OpeningWatch&) override { return {}; }
  DeviceDescription description() const override {
    return {.name = "quiet",
            .device_class = class_,
            .limits = DeviceLimits{.force_newton = 8.0},
            .pulse = DevicePulse{.numbers_packets = true},
            .measures_rotation = class_ == "arm6"};
  }
  DriverExchange exchange(const Vec3&) noexcept override {
    std::this_thread::sleep_for(std::chrono::microseconds(100));
    DriverExchange said{DriverAnswer::Said, {}, DeviceTrouble::None};
    said.state.device_from_handle.translation_mm.x = 0.01 * static_cast<double>(++said_ % 100);
    said.state.deflection.pushed.x = 0.2;
    return said;
  }
  void close() noexcept override {}

 private:
  std::string class_;
  std::int64_t said_ = 0;
};

/// Also while the window says something in each, and takes the hand off now and then.
template <typename Device>
std::uint64_t allocations_in(const std::string& device_class) {
  DevicePort port(std::make_unique<QuietDriver>(device_class));
  while (port.phase() != PortPhase::Running) std::this_thread::yield();
  Device device(port, PortDeviceSetup{});
  RawDeviceState state;
  std::int64_t there = 0;
  const std::uint64_t before = tests::allocations_of_this_thread();
  for (std::int64_t tick = 0; tick < exchanges; ++tick) {
    SteeredDevice::Aim aim;
    aim.is_lifted = tick % 1000 < 100;
    aim.orders = static_cast<std::uint32_t>(tick / 500);
    device.aim(aim);
    there += device.exchange({0.0, 1.0, 0.0}, tick, state) ? 1 : 0;
  }
  const std::uint64_t taken = tests::allocations_of_this_thread() - before;
  EXPECT_EQ(there, exchanges) << device_class;
  return taken;
}

TEST(PortDevices, TakeNoMemoryInAHundredThousandExchanges) {
  EXPECT_EQ(allocations_in<ArmDevice>("arm3"), 0U);
  EXPECT_EQ(allocations_in<ArmDevice>("arm6"), 0U);
  EXPECT_EQ(allocations_in<RateDevice>("rate"), 0U);
}

}  // namespace
}  // namespace hallux::simulator
