// The label beside the teeth hides no panel, and no panel hides it.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/ui/screens/operating/shown_panels.h"
#include "ui/screens/pictures/blade_section_view.h"

namespace hallux::ui {
namespace {

struct LabelledPanels : ShownPanels {
  Rect label_with_tip_at(Point tip) {
    hud.tip = tip;
    hud.tip_lines = {"Far side 3.5 mm ahead", "Plan +0.9 mm, at the end +0.9 mm"};
    hud.inset = &section;
    driver.frame();
    const std::vector<ReadOut>& told = driver.ui().shown().read_outs;
    const auto label = std::ranges::find(told, "operate.ahead", &ReadOut::id);
    return label == told.end() ? Rect{} : label->rect;
  }

  BladeSection section;
};

TEST(HudTip, KeepsItsLabelOffThePanels) {
  LabelledPanels panels;
  for (const Point tip : {Point{700.0F, 320.0F}, Point{760.0F, 300.0F}, Point{600.0F, 760.0F},
                          Point{1150.0F, 420.0F}, Point{770.0F, 330.0F}, Point{300.0F, 720.0F}}) {
    const Rect label = panels.label_with_tip_at(tip);
    ASSERT_FALSE(label.is_empty());
    for (const char* panel : {"operate.panel.inset", "operate.panel.force", "operate.panel.tool",
                              "operate.panel.steps", "operate.panel.mode"}) {
      EXPECT_TRUE(intersection(label, panels.driver.widget(panel).rect).is_empty())
          << panel << " with the tip at " << tip.x << ", " << tip.y;
    }
  }
}

// Messages stand; a label that follows the saw goes elsewhere, be they all around the teeth.
TEST(HudTip, GivesWayToMessages) {
  LabelledPanels panels;
  const Point tip{700.0F, 420.0F};
  const Rect before = panels.label_with_tip_at(tip);
  for (const Rect& message :
       {inset(before, -20.0F), Rect{tip.x - 300.0F, tip.y - 240.0F, 600.0F, 480.0F}}) {
    panels.driver.ui().set_messages_at({message});
    const Rect label = panels.label_with_tip_at(tip);
    ASSERT_FALSE(label.is_empty());
    EXPECT_TRUE(intersection(label, message).is_empty());
    for (const char* panel : {"operate.panel.inset", "operate.panel.tool", "operate.panel.mode"})
      EXPECT_TRUE(intersection(label, panels.driver.widget(panel).rect).is_empty()) << panel;
  }
  panels.driver.ui().set_messages_at({});
  EXPECT_EQ(panels.label_with_tip_at(tip).x, before.x) << "and comes back";
}

}  // namespace
}  // namespace hallux::ui
