// The Falcon's driver before a modelled Falcon: brought up, homed, pushed, and every way in which
// that can fail.
#include "simulator/device/falcon/falcon_driver.h"

#include <gtest/gtest.h>

#include <fstream>

#include "tests/support/served_bus/falcon_counts.h"
#include "tests/support/served_bus/played_channels.h"
#include "tests/support/temporary_directory.h"

namespace hallux::simulator {
namespace {

using tests::FalconModel;

class PlayedFalcon : public testing::Test {
 protected:
  FalconDriver driver() {
    return FalconDriver(
        [this] {
          return OpenedUsb{std::make_unique<tests::PlayedUsb>(model_, is_gone_), {}};
        },
        {firmware_, 10'000.0});
  }

  void write_firmware(const std::vector<std::uint8_t>& image) {
    firmware_ = folder_.path() / "falcon.bin";
    std::ofstream(firmware_, std::ios::binary)
        .write(reinterpret_cast<const char*>(image.data()),
               static_cast<std::streamsize>(image.size()));
  }

  static bool go_on(PortPhase, double) { return true; }

  /// A grip that lies there, homed.
  void put(const Vec3& place_mm) {
    const FalconCounts counts = tests::falcon_counts_at(falcon_middle_mm + place_mm);
    std::copy(counts.begin(), counts.end(), model_.encoders.begin());
    model_.is_homed = true;
  }

  tests::TemporaryDirectory folder_;
  std::filesystem::path firmware_;
  FalconModel model_;
  bool is_gone_ = false;
};

TEST_F(PlayedFalcon, OneThatRunsIsUsedAsItIs) {
  model_.run();
  FalconDriver falcon = driver();
  EXPECT_FALSE(falcon.open(go_on));
  EXPECT_EQ(model_.latency_ms(), 1);
}

TEST_F(PlayedFalcon, WithoutFirmwareItIsLoadedFromTheNamedFile) {
  write_firmware(tests::some_firmware());
  FalconDriver falcon = driver();
  double last = 0.0;
  const TroubleReport trouble = falcon.open([&](PortPhase phase, double fraction) {
    EXPECT_EQ(phase, PortPhase::Loading);
    last = fraction;
    return true;
  });
  EXPECT_FALSE(trouble) << id_of(trouble.trouble);
  EXPECT_EQ(last, 1.0);
  EXPECT_EQ(model_.mode(), FalconModel::Mode::Runs);
}

TEST_F(PlayedFalcon, WithoutAFileItSaysSo) {
  EXPECT_EQ(driver().open(go_on).trouble, DeviceTrouble::NoFirmware);
}

TEST_F(PlayedFalcon, AFileThatIsNoFirmwareIsNamedWithItsByte) {
  write_firmware({0x7F, 'E', 'L', 'F'});
  const TroubleReport trouble = driver().open(go_on);
  EXPECT_EQ(trouble.trouble, DeviceTrouble::BadFirmware);
  EXPECT_EQ(trouble.subject, firmware_);
  EXPECT_EQ(trouble.detail, "byte 0: no boot stream begins here: AA 08 is expected");
  EXPECT_EQ(model_.mode(), FalconModel::Mode::Off) << "nothing of it was sent";
}

TEST_F(PlayedFalcon, AWrongEchoIsTriedAgainTenTimes) {
  write_firmware(tests::some_firmware(200));
  model_.faults.wrong_echo_at = 100;
  model_.faults.failing_loads = 9;
  EXPECT_FALSE(driver().open(go_on));
  model_ = {};
  model_.faults.wrong_echo_at = 100;
  EXPECT_EQ(driver().open(go_on).trouble, DeviceTrouble::WrongEcho);
}

TEST_F(PlayedFalcon, LoadingCanBeStopped) {
  write_firmware(tests::some_firmware());
  FalconDriver falcon = driver();
  EXPECT_FALSE(falcon.open([](PortPhase, double fraction) { return fraction < 0.5; }));
  EXPECT_NE(model_.mode(), FalconModel::Mode::Runs);
}

TEST_F(PlayedFalcon, PulledOutWhileItIsLoadedItIsUnplugged) {
  write_firmware(tests::some_firmware());
  FalconDriver falcon = driver();
  const TroubleReport trouble = falcon.open([&](PortPhase, double fraction) {
    is_gone_ = fraction > 0.5;
    return true;
  });
  EXPECT_EQ(trouble.trouble, DeviceTrouble::Unplugged);
}

TEST_F(PlayedFalcon, TellsItsPlaceAndButtons) {
  model_.run();
  put({20.0, -10.0, 5.0});
  model_.buttons = 5;
  FalconDriver falcon = driver();
  ASSERT_FALSE(falcon.open(go_on));
  const DriverExchange exchange = falcon.exchange({0.0, 0.0, 0.0});
  EXPECT_EQ(exchange.answer, DriverAnswer::Said);
  EXPECT_TRUE(exchange.state.is_homed);
  EXPECT_EQ(exchange.state.buttons, 5U);
  // A count is some hundredths of a millimetre.
  EXPECT_LT(length_of(exchange.state.device_from_handle.translation_mm - Vec3(20.0, -10.0, 5.0)),
            0.1);
}

TEST_F(PlayedFalcon, PushesAsItsLegsNeedIt) {
  model_.run();
  put({0.0, 0.0, -10.0});
  FalconDriver falcon = driver();
  ASSERT_FALSE(falcon.open(go_on));
  static_cast<void>(falcon.exchange({0.0, 0.0, 1.0}));
  EXPECT_EQ(model_.motors(), (std::array<std::int32_t, 3>{})) << "its place was not known";
  static_cast<void>(falcon.exchange({0.0, 0.0, 1.0}));
  for (const std::int32_t motor : model_.motors()) EXPECT_NEAR(motor, -242, 1);
  // More than the motors take: the direction stays.
  static_cast<void>(falcon.exchange({100.0, 0.0, 0.0}));
  EXPECT_EQ(model_.motors()[1], falcon_motor_counts);
  EXPECT_NEAR(model_.motors()[0], -155.0 / 527.0 * falcon_motor_counts, 10.0);
}

TEST_F(PlayedFalcon, UntilItsLegsAreHomeItIsGivenNothingAndShinesRed) {
  model_.run();
  FalconDriver falcon = driver();
  ASSERT_FALSE(falcon.open(go_on));
  for (int i = 0; i < 3; ++i) {
    const DriverExchange exchange = falcon.exchange({5.0, 5.0, 5.0});
    EXPECT_FALSE(exchange.state.is_homed);
  }
  EXPECT_EQ(model_.motors(), (std::array<std::int32_t, 3>{}));
  EXPECT_EQ(model_.lights(), static_cast<std::uint8_t>(FalconLight::Red));
}

TEST_F(PlayedFalcon, WhatIsNoPacketIsToldAndALongerAnswerHarmsNobody) {
  model_.run();
  FalconDriver falcon = driver();
  ASSERT_FALSE(falcon.open(go_on));
  model_.faults.is_garbled = true;
  EXPECT_EQ(falcon.exchange({}).answer, DriverAnswer::Garbled);
  model_.faults = {};
  model_.faults.is_long = true;
  EXPECT_EQ(falcon.exchange({}).answer, DriverAnswer::Said);
  model_.faults = {};
  model_.faults.is_silent = true;
  DriverExchange exchange;
  for (int i = 0; i < 5; ++i) exchange = falcon.exchange({});
  EXPECT_EQ(exchange.answer, DriverAnswer::Nothing);
}

TEST_F(PlayedFalcon, LegsThatCannotStandSoAreNoPlace) {
  model_.run();
  put({0.0, 0.0, 0.0});
  FalconDriver falcon = driver();
  ASSERT_FALSE(falcon.open(go_on));
  static_cast<void>(falcon.exchange({}));
  model_.encoders = {32767, -32768, 32767};
  const DriverExchange exchange = falcon.exchange({});
  EXPECT_EQ(exchange.answer, DriverAnswer::Garbled);
  EXPECT_LT(length_of(exchange.state.device_from_handle.translation_mm), 0.1) << "as before";
}

TEST_F(PlayedFalcon, PulledOutItIsGone) {
  model_.run();
  FalconDriver falcon = driver();
  ASSERT_FALSE(falcon.open(go_on));
  is_gone_ = true;
  const DriverExchange exchange = falcon.exchange({});
  EXPECT_EQ(exchange.answer, DriverAnswer::Gone);
  EXPECT_EQ(exchange.trouble, DeviceTrouble::Unplugged);
  falcon.close();
}

TEST_F(PlayedFalcon, ClosingLeavesNoForce) {
  model_.run();
  put({0.0, 0.0, 0.0});
  FalconDriver falcon = driver();
  ASSERT_FALSE(falcon.open(go_on));
  for (int i = 0; i < 3; ++i) static_cast<void>(falcon.exchange({1.0, 1.0, 1.0}));
  EXPECT_NE(model_.motors(), (std::array<std::int32_t, 3>{}));
  falcon.close();
  EXPECT_EQ(model_.motors(), (std::array<std::int32_t, 3>{}));
  EXPECT_EQ(falcon.exchange({}).answer, DriverAnswer::Gone);
}

}  // namespace
}  // namespace hallux::simulator
