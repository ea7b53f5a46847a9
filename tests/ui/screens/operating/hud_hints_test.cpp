// Where the next thing to do stands while the tool passes behind it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/ui/screens/operating/shown_panels.h"

namespace hallux::ui {
namespace {

using testing::IsEmpty;

constexpr const char* hint = "operate.hint";

struct HintedPanels : ShownPanels {
  using ShownPanels::ShownPanels;

  /// As the screen does: where the hints stood is told to the next frame.
  Rect hint_with_tool_at(std::optional<Point> tool) {
    hud.hint = "Bone lies 12.0 mm ahead: push the saw on until it is 0.0 mm.";
    hud.are_hints_low = answer.are_hints_low;
    hud.tool.clear();
    if (tool) hud.tool.push_back({*tool, 20.0F});
    driver.frame();
    return driver.widget(hint).rect;
  }
};

TEST(HudHints, StandBelowTheStepsAndAboveTheLowerPanelsWhereTheToolPassesBehind) {
  HintedPanels panels;
  const Rect high = panels.hint_with_tool_at(std::nullopt);
  const Rect low = panels.hint_with_tool_at(high.centre());
  EXPECT_GT(low.y, 500.0F);
  EXPECT_LT(low.bottom(), panels.driver.widget("operate.panel.force").rect.y);
  EXPECT_EQ(panels.hint_with_tool_at(std::nullopt), high);
}

TEST(HudHints, GoBackOnlyWhenTheToolIsWellAway) {
  HintedPanels panels;
  const Rect high = panels.hint_with_tool_at(std::nullopt);
  const Point beside{high.mid_x(), high.bottom() + 30.0F};
  EXPECT_EQ(panels.hint_with_tool_at(beside), high);
  const Rect low = panels.hint_with_tool_at(high.centre());
  EXPECT_EQ(panels.hint_with_tool_at(beside), low);
  EXPECT_EQ(panels.hint_with_tool_at(Point{high.mid_x(), high.bottom() + 120.0F}), high);
}

TEST(HudHints, StayBelowTheStepsWhereTheToolIsBehindBothPlaces) {
  HintedPanels panels;
  const Rect high = panels.hint_with_tool_at(std::nullopt);
  const Rect low = panels.hint_with_tool_at(high.centre());
  panels.hint_with_tool_at(std::nullopt);
  panels.hud.tool = {{high.centre(), 20.0F}, {low.centre(), 20.0F}};
  panels.hud.are_hints_low = panels.answer.are_hints_low;
  panels.driver.frame();
  EXPECT_EQ(panels.driver.widget(hint).rect, high);
  for (const SeenText& text : panels.driver.content().texts)
    EXPECT_TRUE(!high.encloses(text.rect) || text.presence == 1.0F) << "read all the same";
}

TEST(HudHints, StandClearOfTheOtherPanelsAtEveryScale) {
  for (const float scale : {0.8F, 1.0F, 1.5F}) {
    HintedPanels panels(scale, {1280.0F, 720.0F});
    panels.hud.health.trouble = "The disk is nearly full.";
    const Rect high = panels.hint_with_tool_at(std::nullopt);
    const Rect low = panels.hint_with_tool_at(high.centre());
    EXPECT_THAT(panels.driver.faults(), IsEmpty()) << scale;
    EXPECT_LE(low.bottom(), panels.driver.widget("operate.panel.trouble").rect.y) << scale;
  }
}

}  // namespace
}  // namespace hallux::ui
