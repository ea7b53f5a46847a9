#include "ui/screens/replay/player.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/ui/widgets/driver.h"

namespace hallux::ui {
namespace {

using testing::IsEmpty;

/// A player alone in a window, ten seconds long, with events at 2 and 5 s.
struct Played {
  explicit Played(double now_s = 0.0)
      : driver(texts, [this](Ui& ui) {
          player.advance(ui);
          player.draw(ui, {20.0F, 20.0F, width, Player::height});
        }) {
    player.open(10.0, {2.0, 5.0}, now_s);
    driver.settle();
  }

  float width = 1200.0F;
  const Texts texts = english_texts();
  Player player;
  Driver driver;
};

TEST(Player, SpacePlaysAndStops) {
  Played played;
  played.driver.send(key_events(Key::Space));
  for (int frame = 0; frame < 60; ++frame) played.driver.frame();
  EXPECT_TRUE(played.player.is_playing());
  EXPECT_NEAR(played.player.now_s(), 1.0, 0.1);
  played.driver.press(Key::Space);
  EXPECT_FALSE(played.player.is_playing());
  const double now_s = played.player.now_s();
  played.driver.wait(1.0);
  EXPECT_EQ(played.player.now_s(), now_s);
}

TEST(Player, BracketsChangeTheSpeed) {
  Played played;
  for (int step = 0; step < 2; ++step) played.driver.press(Key::RightBracket);
  played.driver.send(key_events(Key::Space));
  for (int frame = 0; frame < 60; ++frame) played.driver.frame();
  EXPECT_NEAR(played.player.now_s(), 4.0, 0.3);
}

TEST(Player, InANarrowWindowTheSpeedIsOneButton) {
  Played played;
  EXPECT_TRUE(played.driver.has("replay.speed.3"));
  played.width = 400.0F;
  played.driver.frame();
  EXPECT_FALSE(played.driver.has("replay.speed.3"));
  for (const char* next : {"2\xC3\x97", "4\xC3\x97", "0.1\xC3\x97"}) {
    played.driver.click("replay.speed");
    EXPECT_TRUE(played.driver.sees(next));
  }
  EXPECT_THAT(played.driver.faults(), IsEmpty());
}

TEST(Player, StepsBySampleSecondAndTenSeconds) {
  Played played(4.0);
  played.driver.press(Key::Period);
  EXPECT_NEAR(played.player.now_s(), 4.001, 1e-9);
  played.driver.press(Key::Comma);
  played.driver.press(Key::Comma);
  EXPECT_NEAR(played.player.now_s(), 3.999, 1e-9);
  played.driver.press(Key::Right);
  EXPECT_NEAR(played.player.now_s(), 4.999, 1e-9);
  played.driver.press(Key::Left);
  EXPECT_NEAR(played.player.now_s(), 3.999, 1e-9);
  played.driver.press(Key::Right, {.shift = true});
  EXPECT_EQ(played.player.now_s(), 10.0) << "not beyond the end";
  played.driver.press(Key::Left, {.shift = true});
  EXPECT_EQ(played.player.now_s(), 0.0);
}

TEST(Player, StepsFromEventToEvent) {
  Played played;
  for (const double expected_s : {2.0, 5.0, 10.0}) {
    played.driver.press(Key::N);
    EXPECT_EQ(played.player.now_s(), expected_s);
  }
  for (const double expected_s : {5.0, 2.0, 0.0}) {
    played.driver.press(Key::N, {.shift = true});
    EXPECT_EQ(played.player.now_s(), expected_s);
  }
  played.driver.click("replay.next");
  EXPECT_EQ(played.player.now_s(), 2.0);
  played.driver.click("replay.before");
  EXPECT_EQ(played.player.now_s(), 0.0);
}

TEST(Player, StopsAtTheEndAndBeginsAgain) {
  Played played(9.9);
  played.driver.click("replay.play");
  for (int frame = 0; frame < 30; ++frame) played.driver.frame();
  EXPECT_FALSE(played.player.is_playing());
  EXPECT_EQ(played.player.now_s(), 10.0);
  played.driver.send(key_events(Key::Space));
  for (int frame = 0; frame < 10; ++frame) played.driver.frame();
  EXPECT_LT(played.player.now_s(), 1.0);
  EXPECT_THAT(played.driver.faults(), IsEmpty());
}

}  // namespace
}  // namespace hallux::ui
