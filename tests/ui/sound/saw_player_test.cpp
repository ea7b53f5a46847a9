/// The player with OpenAL's own device that plays to nobody.
#include "ui/sound/saw_player.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <thread>

namespace hallux::ui {
namespace {

using Clock = std::chrono::steady_clock;

/// Waits at most five seconds for what must happen in a tenth of one.
template <typename Claim>
bool comes_true(const Claim& claim) {
  for (const auto end = Clock::now() + std::chrono::seconds(5); Clock::now() < end;) {
    if (claim()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  return claim();
}

class SawPlayerTest : public ::testing::Test {
 protected:
  static void SetUpTestSuite() { ::setenv("ALSOFT_DRIVERS", "null", 1); }
};

TEST_F(SawPlayerTest, KeepsTheDeviceInBuffers) {
  SawPlayer player;
  player.play({.runs = true});
  EXPECT_TRUE(comes_true([&] { return player.buffers() >= 12; }));
  EXPECT_EQ(player.state(), SawPlayer::State::Playing);
}

TEST_F(SawPlayerTest, PlaysInRealTime) {
  SawPlayer player;
  ASSERT_TRUE(comes_true([&] { return player.buffers() >= 8; }));
  const long before = player.buffers();
  const auto begin = Clock::now();
  ASSERT_TRUE(comes_true([&] { return player.buffers() >= before + 25; }));
  // 25 buffers of 20 ms; a late thread may find four of them waiting.
  EXPECT_GT(Clock::now() - begin, std::chrono::milliseconds(25 * 20 - 5 * 20));
}

TEST_F(SawPlayerTest, ComesAndGoesMoreThanOnce) {
  for (int i = 0; i < 3; ++i) {
    SawPlayer player;
    EXPECT_TRUE(comes_true([&] { return player.state() == SawPlayer::State::Playing; }));
  }
}

TEST_F(SawPlayerTest, MayGoBeforeItsDeviceIsOpen) {
  for (int i = 0; i < 10; ++i) {
    SawPlayer player;
    player.play({.runs = true});
  }
}

}  // namespace
}  // namespace hallux::ui
