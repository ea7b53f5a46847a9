// The lines at the lower edge are whole at every scale, on a ground of their own, below the panels.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/ui/screens/operating/shown_panels.h"
#include "ui/screens/operating/hand/gestures.h"

namespace hallux::ui {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

TEST(HudFoot, TellsEachMovementWholeAtEveryScale) {
  for (const float scale : {0.8F, 1.0F, 1.25F, 1.5F, 2.0F}) {
    for (const HandState hand : {HandState::Led, HandState::LedFree, HandState::Lifted}) {
      ShownPanels panels(scale, {1280.0F, 720.0F});
      panels.hud.hand = hand;
      panels.hud.is_simulated = true;
      panels.driver.frame();
      EXPECT_THAT(panels.driver.faults(), IsEmpty()) << scale;
      const Rect foot = panels.place_told("operate.foot");
      EXPECT_TRUE(panels.driver.ui().display().encloses(foot)) << scale;
      EXPECT_GE(foot.y, panels.driver.widget("operate.panel.force").rect.bottom()) << scale;
      std::string seen;
      for (const SeenText& text : panels.driver.content().texts)
        if (foot.encloses(text.rect)) seen += " " + text.text;
      EXPECT_THAT(seen, HasSubstr("reviewed.")) << scale;
      if (hand == HandState::Lifted) {
        EXPECT_THAT(seen, HasSubstr("lifted")) << scale;
        continue;
      }
      for (const BoundGesture& bound : bound_gestures) {
        const std::string words = std::string(panels.driver.ui().text(bound.input_text)) + ": " +
                                  std::string(panels.driver.ui().text(bound.gesture_text));
        EXPECT_TRUE(!bound.is_usual || seen.find(words) != std::string::npos) << words << scale;
      }
    }
  }
}

TEST(HudFoot, TakesNoRoomWhereThereIsNothingToTell) {
  ShownPanels panels;
  panels.hud.is_reviewed = true;
  panels.driver.frame();
  EXPECT_TRUE(panels.place_told("operate.foot").is_empty());
  EXPECT_NEAR(panels.driver.widget("operate.panel.force").rect.bottom(), 0.94F * 900.0F, 0.5F);
}

}  // namespace
}  // namespace hallux::ui
