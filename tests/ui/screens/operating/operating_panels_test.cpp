// What is shown while somebody operates, and where: panels that fade, help that goes by its key,
// the layout of the left hand.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/ui/screens/operating/shown_panels.h"
#include "tests/ui/screens/operating/some_operation.h"
#include "ui/screens/operating/hud/hud_panel.h"

namespace hallux::ui {
namespace {

using database::AttemptKind;
using testing::Each;
using testing::IsEmpty;
using testing::Not;

const std::vector<std::string> lower_panels{"operate.panel.force", "operate.panel.tool",
                                            "operate.panel.plan"};

/// All there may be in an attempt.
struct AllPanels : ShownPanels {
  explicit AllPanels(float scale = 1.0F, bool is_left_handed = false)
      : ShownPanels(scale, {1280.0F, 720.0F}) {
    section.section.bone_mm = {{{0.0, -9.0}, {15.0, -9.0}, {15.0, 9.0}, {0.0, 9.0}}};
    section.way = WayAhead{WayEnd::FarSide, 3.6};
    hud.is_left_handed = is_left_handed;
    hud.is_simulated = true;
    hud.hand = HandState::Led;
    hud.is_saw_on = hud.is_irrigated = true;
    hud.saw.cycles_per_minute = 12000.0;
    hud.force_newton = 8.5;
    hud.bone_celsius = 57.0;
    hud.hint = "Push force is 8.5 N: keep it between 6.0 and 14.0 N. 3.6 mm are left to saw.";
    hud.plan =
        HudPlan{{.roll_rad = 0.02, .angle_rad = 0.02, .distance_mm = 0.9, .end_distance_mm = {}},
                {.count = 2},
                {LiveBand{1.0, 8.0}, LiveBand{0.5, 3.0}}};
    hud.inset = &section;
    driver.frame();
  }
  /// How much of them is there, of all texts on the panel.
  std::vector<float> presences(std::string_view panel) const {
    std::vector<float> found;
    const Rect& rect = driver.widget(panel).rect;
    for (const SeenText& text : driver.content().texts)
      if (rect.encloses(text.rect)) found.push_back(text.presence);
    return found;
  }
  std::vector<Rect> panels() const {
    std::vector<Rect> rects;
    for (const Widget& widget : driver.content().widgets)
      if (widget.id.starts_with("operate.panel.") || widget.id == "operate.hint")
        rects.push_back(widget.rect);
    return rects;
  }

  BladeSection section;
};

TEST(HudFading, EachPanelFadesWhileTheToolIsBehindItAndNoOther) {
  AllPanels panels;
  std::vector<std::string> names = lower_panels;
  names.insert(names.end(), {"operate.panel.inset", "operate.panel.mode", "operate.panel.steps"});
  for (const std::string& name : names) {
    panels.hud.tool = {{panels.driver.widget(name).rect.centre(), 12.0F}};
    panels.driver.frame();
    for (const std::string& other : names) {
      ASSERT_THAT(panels.presences(other), Not(IsEmpty())) << other;
      EXPECT_THAT(panels.presences(other), Each(other == name ? faded_presence : 1.0F))
          << other << " with the tool behind " << name;
    }
  }
  panels.hud.tool.clear();
  panels.driver.frame();
  for (const std::string& name : names) EXPECT_THAT(panels.presences(name), Each(1.0F)) << name;
}

TEST(HudFading, WhatMayHideBehindAPanelFadesNone) {
  AllPanels panels;
  for (const std::string& name : lower_panels) {
    panels.hud.tool = {{panels.driver.widget(name).rect.centre(), 12.0F, false}};
    panels.driver.frame();
    EXPECT_THAT(panels.presences(name), Each(1.0F)) << name;
  }
}

TEST(HudFading, TheFootIsAlwaysRead) {
  AllPanels panels;
  const Rect foot = panels.place_told("operate.foot");
  panels.hud.tool = {{foot.centre(), 300.0F}};
  panels.driver.frame();
  for (const SeenText& text : panels.driver.content().texts)
    EXPECT_TRUE(!foot.encloses(text.rect) || text.presence == 1.0F) << text.text;
}

class Layout : public testing::TestWithParam<float> {};

void expect_apart(const std::vector<Rect>& rects, const Rect& display) {
  for (std::size_t i = 0; i < rects.size(); ++i) {
    EXPECT_TRUE(display.encloses(rects[i])) << i;
    for (std::size_t other = 0; other < i; ++other)
      EXPECT_TRUE(intersection(rects[i], rects[other]).is_empty()) << i << " and " << other;
  }
}

TEST_P(Layout, NoPanelLiesOverAnother) {
  for (const bool is_left_handed : {false, true}) {
    AllPanels panels(GetParam(), is_left_handed);
    EXPECT_THAT(panels.driver.faults(), IsEmpty());
    panels.hud.tip = Point{0.48F * panels.driver.ui().display().w, 195.0F};
    panels.hud.tip_lines = {"Far side 10.0 mm ahead", "Plan +0.2 mm, at the end +0.2 mm"};
    panels.hud.tool = {{*panels.hud.tip, 60.0F}};
    panels.driver.frame();
    std::vector<Rect> rects = panels.panels();
    rects.push_back(panels.place_told("operate.ahead"));
    EXPECT_GE(rects.size(), 9U);
    expect_apart(rects, panels.driver.ui().display());
  }
}

TEST_P(Layout, ManyStepsStandClearOfTheNameAndLowHintsOfTheSection) {
  for (const std::string title : {"Cut the eminence", "Drill for the screw that holds the head"}) {
    AllPanels panels(GetParam());
    const Rect display = panels.driver.ui().display();
    panels.hud.badge = {0.06F * display.w, 0.06F * display.h + 56.0F, 180.0F, 36.0F};
    panels.hud.steps.assign(13, {.title = title});
    panels.hud.step = 1;
    panels.hud.step_action = "Done";
    panels.driver.frame();
    panels.hud.tool = {{panels.driver.widget("operate.hint").rect.centre(), 40.0F}};
    panels.driver.frame();
    EXPECT_TRUE(panels.answer.are_hints_low);
    std::vector<Rect> rects = panels.panels();
    rects.push_back(panels.hud.badge);
    expect_apart(rects, display);
  }
}

TEST_P(Layout, TheLeftHandHasTheMirrorOfTheRight) {
  AllPanels right(GetParam()), left(GetParam(), true);
  const float width = right.driver.ui().display().w;
  std::vector<std::string> names = lower_panels;
  names.push_back("operate.panel.inset");
  const auto expect_mirrored = [&](const std::string& name) {
    const Rect &a = right.driver.widget(name).rect, &b = left.driver.widget(name).rect;
    EXPECT_NEAR(b.x, width - a.right(), 0.6F) << name;
    EXPECT_NEAR(b.w, a.w, 0.6F) << name;
    EXPECT_NEAR(b.y, a.y, 0.6F) << name;
    EXPECT_NEAR(b.h, a.h, 0.6F) << name;
  };
  for (const std::string& name : names) expect_mirrored(name);
  EXPECT_GT(right.driver.widget("operate.panel.force").rect.x, 0.5F * width);
  right.hud.is_health_open = left.hud.is_health_open = true;
  right.driver.frame();
  left.driver.frame();
  expect_mirrored("operate.panel.health");
}

INSTANTIATE_TEST_SUITE_P(Scales, Layout, testing::Values(1.0F, 1.5F));

TEST(HudTip, ForceAndLabelChangeSidesWithTheHand) {
  const auto shown = [](bool is_left_handed) {
    auto panels = std::make_unique<AllPanels>(1.0F, is_left_handed);
    panels->hud.tip = Point{640.0F, 470.0F};
    panels->hud.tip_lines = {"Far side 3.6 mm ahead"};
    panels->driver.frame();
    return std::array{panels->place_told("operate.force.tip"), panels->place_told("operate.ahead")};
  };
  const auto [right_force, right_label] = shown(false);
  const auto [left_force, left_label] = shown(true);
  EXPECT_LT(right_force.right(), 640.0F);
  EXPECT_GT(right_label.x, 640.0F);
  EXPECT_NEAR(left_force.mid_x() - 640.0F, 640.0F - right_force.mid_x(), 0.6F);
  EXPECT_LT(left_label.right(), 640.0F);
}

// -- by their keys, on the screen

class ShownHelp : public testing::Test {
 protected:
  ShownHelp() { person_.begin(); }
  bool has_told(std::string_view id) {
    const auto& all = person_.driver().content().read_outs;
    return std::ranges::find(all, id, &ReadOut::id) != all.end();
  }
  std::string told(std::string_view id) {
    const auto& all = person_.driver().content().read_outs;
    const auto found = std::ranges::find(all, id, &ReadOut::id);
    return found == all.end() ? std::string() : found->text;
  }

  OperableCourse course_{"silver"};
  Operator person_{course_, AttemptKind::Practice};
};

TEST_F(ShownHelp, TheSectionGoesAndComesWithVAndTellsWhatTheLabelTells) {
  ASSERT_TRUE(person_.until([&] { return has_told("operate.inset"); }));
  EXPECT_TRUE(person_.driver().has("operate.panel.inset"));
  EXPECT_THAT(told("operate.ahead"), testing::StartsWith(told("operate.inset") + ". Plan "));
  person_.press(Key::V);
  EXPECT_FALSE(person_.driver().has("operate.panel.inset"));
  person_.press(Key::V);
  EXPECT_TRUE(person_.driver().has("operate.panel.inset"));
}

TEST_F(ShownHelp, HintsGoAndComeWithTAndTheMeterKeepsItsRange) {
  ASSERT_TRUE(person_.until([&] { return has_told("operate.hint"); }));
  const std::string force = told("operate.force");
  person_.press(Key::T);
  EXPECT_FALSE(has_told("operate.hint"));
  EXPECT_EQ(told("operate.force"), force);
  person_.press(Key::T);
  EXPECT_TRUE(person_.until([&] { return has_told("operate.hint"); }));
}

TEST_F(ShownHelp, TheNeighbourGoesAndComesWithN) {
  EXPECT_EQ(person_.scenes.bones, 2U);
  person_.press(Key::N);
  EXPECT_EQ(person_.scenes.bones, 1U);
  person_.press(Key::N);
  EXPECT_EQ(person_.scenes.bones, 2U);
}

TEST_F(ShownHelp, KTurnsThePanelsToTheOtherHandAndIsAPreference) {
  const Rect before = person_.driver().widget("operate.panel.force").rect;
  ASSERT_FALSE(person_.shell().hand().is_left_handed);
  person_.press(Key::K);
  EXPECT_TRUE(person_.shell().hand().is_left_handed);
  const Rect after = person_.driver().widget("operate.panel.force").rect;
  EXPECT_NEAR(after.x, 1440.0F - before.right(), 0.6F);
  person_.press(Key::K);
  EXPECT_EQ(person_.driver().widget("operate.panel.force").rect, before);
}

TEST_F(ShownHelp, TheStartShowsAWholeSawAndEachPanelOfIt) {
  EXPECT_EQ(person_.scenes.saw->handpiece_presence, 1.0);
  for (const std::string& name : lower_panels) {
    const Rect& rect = person_.driver().widget(name).rect;
    for (const SeenText& text : person_.driver().content().texts)
      EXPECT_TRUE(!rect.encloses(text.rect) || text.presence == 1.0F) << text.text;
  }
}

TEST_F(ShownHelp, AHandpieceThatIsSeenThroughFadesNoPanel) {
  // Along the blade over the handle: of the three sights in its plane the one along the feed.
  for (int turn = 0; turn < 3 && person_.scenes.saw->handpiece_presence == 1.0; ++turn)
    person_.press(Key::Digit8);
  ASSERT_LT(person_.scenes.saw->handpiece_presence, 0.5);
  person_.make_frames(2);
  for (const std::string& name : lower_panels) {
    const Rect& rect = person_.driver().widget(name).rect;
    for (const SeenText& text : person_.driver().content().texts)
      EXPECT_TRUE(!rect.encloses(text.rect) || text.presence == 1.0F) << text.text;
  }
}

}  // namespace
}  // namespace hallux::ui
