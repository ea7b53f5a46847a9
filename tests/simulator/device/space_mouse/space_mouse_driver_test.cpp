#include "simulator/device/space_mouse/space_mouse_driver.h"

#include <gtest/gtest.h>

#include "tests/support/served_bus/played_channels.h"

namespace hallux::simulator {
namespace {

class PlayedSpaceMouse : public testing::TestWithParam<bool> {
 protected:
  void SetUp() override {
    model_.is_older = GetParam();
    ASSERT_FALSE(driver_.open([](PortPhase, double) { return true; }));
  }

  tests::SpaceMouseModel model_;
  bool is_gone_ = false;
  SpaceMouseDriver driver_{
      [this] {
        return OpenedHid{std::make_unique<tests::PlayedHid>(model_, is_gone_), {}};
      },
      "SpaceMouse", 350};
};

TEST_P(PlayedSpaceMouse, ItsLightIsOnWhileItIsUsed) {
  EXPECT_EQ(model_.lights, (std::vector<bool>{true}));
  driver_.close();
  EXPECT_EQ(model_.lights, (std::vector<bool>{true, false}));
}

TEST_P(PlayedSpaceMouse, TellsTheNewestOfWhatWaits) {
  model_.push({350, 0, 0}, {0, 0, 0});
  model_.press(2);
  model_.push({0, 35, -70}, {0, 0, 175});
  const DriverExchange exchange = driver_.exchange({});
  EXPECT_EQ(exchange.answer, DriverAnswer::Said);
  EXPECT_EQ(exchange.state.deflection, (Deflection{{0.0, 0.2, 0.1}, {0.0, -0.5, 0.0}}));
  EXPECT_EQ(exchange.state.buttons, 2U);
  EXPECT_EQ(driver_.exchange({}).answer, DriverAnswer::Nothing);
  EXPECT_EQ(driver_.exchange({}).state.buttons, 2U) << "silence means as before";
}

TEST_P(PlayedSpaceMouse, RubbishChangesNothingAndAPulledPlugIsTold) {
  model_.push({350, 0, 0}, {0, 0, 0});
  static_cast<void>(driver_.exchange({}));
  model_.say({1, 2, 3});
  const DriverExchange garbled = driver_.exchange({});
  EXPECT_EQ(garbled.answer, DriverAnswer::Garbled);
  EXPECT_EQ(garbled.state.deflection.pushed.x, 1.0);
  is_gone_ = true;
  EXPECT_EQ(driver_.exchange({}).trouble, DeviceTrouble::Unplugged);
}

INSTANTIATE_TEST_SUITE_P(OlderAndNewer, PlayedSpaceMouse, testing::Bool());

TEST(SpaceMouse, IsKnownByUseAndNumberNotByName) {
  EXPECT_TRUE(is_space_mouse(0x256F, 0xC635, multi_axis_controller));
  EXPECT_TRUE(is_space_mouse(0x256F, 0xC7FF, multi_axis_controller)) << "one that is yet to come";
  EXPECT_TRUE(is_space_mouse(0x046D, 0xC626, multi_axis_controller));
  EXPECT_FALSE(is_space_mouse(0x046D, 0xC52B, multi_axis_controller));
  EXPECT_FALSE(is_space_mouse(0x256F, 0xC650, multi_axis_controller));
  EXPECT_FALSE(is_space_mouse(0x256F, 0xC635, {0x01, 0x02})) << "its own mouse interface";
}

}  // namespace
}  // namespace hallux::simulator
