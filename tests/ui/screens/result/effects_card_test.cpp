#include "ui/screens/result/effects_card.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/ui/widgets/driver.h"

namespace hallux::ui {
namespace {

using testing::IsEmpty;

TEST(EffectsCard, SaysWhereNothingWasRecordedAndWhereNoZoneWasWatched) {
  const Texts texts = english_texts();
  EffectFacts effects;
  TimelineState state;
  Driver driver(texts, [&](Ui& ui) {
    draw_effects(ui, {0.0F, 0.0F, 700.0F, effects_height(ui, effects, 700.0F, state)}, effects,
                 std::nullopt, state);
  });
  EXPECT_TRUE(driver.sees("Nothing was recorded"));
  EXPECT_THAT(driver.faults(), IsEmpty());
  effects.traces.points = {{}};
  driver.frame();
  EXPECT_TRUE(driver.sees("none watched"));
  EXPECT_TRUE(driver.sees("37 °C"));
  EXPECT_FALSE(driver.has("result.effects.hottest")) << "body heat has no moment";
  EXPECT_THAT(driver.faults(), IsEmpty());
}

TEST(EffectsCard, ItsTimeZoomsAndTellsItsMarksWhileTheWheelTurnsThePage) {
  const Texts texts = english_texts();
  EffectFacts effects;
  effects.duration_s = 600.0;
  effects.traces.points = {{}};
  effects.events = {{100.0, Meaning::Warn, "replay.event.kick"}};
  TimelineState state;
  std::optional<double> asked_s;
  float height = 0.0F;
  Driver driver(texts, [&](Ui& ui) {
    height = effects_height(ui, effects, 1100.0F, state);
    if (const auto moment = draw_effects(ui, {20.0F, 20.0F, 1100.0F, height}, effects, {}, state))
      asked_s = moment;
  });
  const Rect line = driver.widget("result.effects.timeline").rect;
  driver.wheel({line.mid_x(), line.mid_y()}, 3.0F);
  EXPECT_FALSE(state.range.has_value());
  driver.click("result.effects.time.nearer");
  EXPECT_TRUE(driver.sees("of 10:00"));
  driver.click("result.effects.time.all");
  driver.click("result.effects.timeline.event.1");
  EXPECT_EQ(asked_s, 100.0);
  const float before = height;
  driver.click("result.effects.time.legend");
  EXPECT_TRUE(driver.sees("Warning"));
  EXPECT_GT(height, before) << "the legend has room of its own";
  EXPECT_THAT(driver.faults(), IsEmpty());
}

}  // namespace
}  // namespace hallux::ui
