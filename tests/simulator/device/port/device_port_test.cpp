// A port on its own thread.
#include "simulator/device/port/device_port.h"

#include <gtest/gtest.h>

#include <condition_variable>
#include <functional>

#include "tests/simulator/device/port/played_driver.h"

namespace hallux::simulator {
namespace {

using namespace std::chrono_literals;

bool comes(const std::function<bool()>& is_so) {
  const auto end = std::chrono::steady_clock::now() + 5s;
  while (!is_so() && std::chrono::steady_clock::now() < end) std::this_thread::sleep_for(1ms);
  return is_so();
}

/// What a driver was given and asked, to be looked at while its port has it.
struct Seen {
  std::atomic<double> force_newton{-1.0};
  std::atomic<int> closed{0};
  std::atomic<bool> is_hanging{false};
};

/// Answers each millisecond, unless it hangs.
class PacedDriver final : public DeviceDriver {
 public:
  explicit PacedDriver(Seen& seen, TroubleReport opening = {})
      : seen_(seen), opening_(std::move(opening)) {}

  TroubleReport open(const OpeningWatch& watch) override {
    while (is_opening_for_ever && watch(PortPhase::Loading, 0.5)) std::this_thread::sleep_for(1ms);
    return opening_;
  }
  DeviceDescription description() const override {
    return {"paced", "arm3", DeviceLimits{.force_newton = 8.0}, {.numbers_packets = true}};
  }
  DriverExchange exchange(const Vec3& force_in_device_newton) noexcept override {
    seen_.force_newton = length_of(force_in_device_newton);
    do {
      std::this_thread::sleep_for(1ms);
    } while (seen_.is_hanging);
    DriverExchange exchange{DriverAnswer::Said, {}, DeviceTrouble::None};
    exchange.state.device_from_handle.translation_mm = {1.0, 2.0, 3.0};
    return exchange;
  }
  void close() noexcept override { ++seen_.closed; }

  bool is_opening_for_ever = false;

 private:
  Seen& seen_;
  TroubleReport opening_;
};

TEST(DevicePort, TellsWhatTheDeviceSaysAndGivesItTheForce) {
  Seen seen;
  DevicePort port(std::make_unique<PacedDriver>(seen));
  EXPECT_TRUE(comes([&] { return port.newest().packet > 3; }));
  EXPECT_EQ(port.phase(), PortPhase::Running);
  EXPECT_EQ(port.newest().said.device_from_handle.translation_mm, Vec3(1.0, 2.0, 3.0));
  EXPECT_TRUE(comes([&] {
    port.say({3.0, 0.0, 0.0});
    return seen.force_newton > 0.1;
  }));
  EXPECT_FALSE(port.trouble());
  EXPECT_GT(port.figures().packets, 3U);
}

TEST(DevicePort, ABorrowerThatHangsLeavesNoForce) {
  Seen seen;
  DevicePort port(std::make_unique<PacedDriver>(seen));
  ASSERT_TRUE(comes([&] {
    port.say({3.0, 0.0, 0.0});
    return seen.force_newton > 0.1;
  }));
  EXPECT_TRUE(comes([&] { return seen.force_newton == 0.0; }));
}

TEST(DevicePort, ADriverThatHangsHoldsNobodyWhoTalksToThePort) {
  Seen seen;
  DevicePort port(std::make_unique<PacedDriver>(seen));
  ASSERT_TRUE(comes([&] { return port.newest().packet > 3; }));
  seen.is_hanging = true;
  std::this_thread::sleep_for(5ms);
  const auto before = std::chrono::steady_clock::now();
  for (int i = 0; i < 1000; ++i) {
    port.say({1.0, 0.0, 0.0});
    static_cast<void>(port.newest());
  }
  EXPECT_LT(std::chrono::steady_clock::now() - before, 1s);
  seen.is_hanging = false;
}

TEST(DevicePort, ATroubleOfTheOpeningIsTold) {
  Seen seen;
  DevicePort port(std::make_unique<PacedDriver>(
      seen, TroubleReport{DeviceTrouble::NoPermission, "/dev/hidraw3", "Permission denied"}));
  EXPECT_TRUE(comes([&] { return port.phase() == PortPhase::Ended; }));
  EXPECT_EQ(port.trouble(),
            (TroubleReport{DeviceTrouble::NoPermission, "/dev/hidraw3", "Permission denied"}));
  EXPECT_EQ(port.newest().trouble, DeviceTrouble::NoPermission);
}

TEST(DevicePort, LettingGoClosesItAlsoWhileItOpens) {
  Seen seen;
  { DevicePort port(std::make_unique<PacedDriver>(seen)); }
  EXPECT_EQ(seen.closed, 1);
  {
    auto driver = std::make_unique<PacedDriver>(seen);
    driver->is_opening_for_ever = true;
    DevicePort port(std::move(driver));
    EXPECT_TRUE(comes([&] { return port.newest().phase == PortPhase::Loading; }));
  }
  EXPECT_EQ(seen.closed, 2);
}

}  // namespace
}  // namespace hallux::simulator
