/// The player where OpenAL finds no device: a driver is asked for that does not exist.
#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <thread>

#include "ui/sound/saw_player.h"

namespace hallux::ui {
namespace {

TEST(SawPlayerWithoutDevice, IsSilentAndHarmless) {
  ::setenv("ALSOFT_DRIVERS", "none_of_that_name", 1);
  SawPlayer player;
  for (int i = 0; i < 2500 && player.state() == SawPlayer::State::Opening; ++i) {
    player.play({.runs = true, .load = 1.0});
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  EXPECT_EQ(player.state(), SawPlayer::State::NoDevice);
  player.play({.runs = true});
  EXPECT_EQ(player.buffers(), 0);
}

}  // namespace
}  // namespace hallux::ui
