// A pointer that an area has caught: only its way is heard, and what lies over the area is left
// alone.
#include <gtest/gtest.h>

#include <array>

#include "tests/ui/widgets/driver.h"
#include "ui/widgets/controls/button.h"

namespace hallux::ui {
namespace {

/// An area that has the pointer, under a button, for as long as it is told to.
struct Captor {
  explicit Captor(bool may_capture = true) : driver(texts, [this](Ui& ui) { draw(ui); }) {
    driver.ui().set_can_capture(may_capture);
  }

  void draw(Ui& ui) {
    seen = ui.area("view", "View", {0, 0, 400, 300});
    way.x += seen.way.x, way.y += seen.way.y;
    dragged.x += seen.dragged[0].x, dragged.y += seen.dragged[0].y;
    for (std::size_t each = 0; each < clicks.size(); ++each) clicks[each] += seen.clicked[each];
    wheel += seen.wheel;
    presses += button(ui, "over", {100, 100, 200, 100}, {"Over it"});
    if (wants) ui.capture_pointer("view");
  }

  AreaResponse seen;
  Point way, dragged;
  std::array<int, mouse_button_count> clicks{};
  float wheel = 0.0F;
  int presses = 0;
  bool wants = false;
  const Texts texts = english_texts();
  Driver driver;
};

TEST(CapturedPointer, GoesBeyondEveryEdgeAndLeavesWhatItLiesOverAlone) {
  Captor captor;
  captor.driver.move_to({200, 150});
  captor.wants = true;
  captor.driver.frame();
  EXPECT_EQ(captor.driver.ui().captured_by(), "view");
  EXPECT_EQ(captor.driver.ui().pointer_shape(), PointerShape::Hidden);
  captor.driver.move_to({-900, 150});
  EXPECT_TRUE(captor.seen.is_captured);
  EXPECT_EQ(captor.way, (Point{-1100, 0}));
  captor.driver.send(click_events({200, 150}));
  captor.driver.send(click_events({200, 150}, MouseButton::Right));
  captor.driver.settle();
  EXPECT_EQ(captor.presses, 0);
  EXPECT_EQ(captor.clicks, (std::array<int, 3>{1, 1, 0}));
  captor.driver.wheel({200, 150}, 2.0F);
  EXPECT_EQ(captor.wheel, 2.0F) << "over the button, too";
}

TEST(CapturedPointer, DragsWhileAButtonIsHeldAndIsNoClickThen) {
  Captor captor;
  captor.wants = true;
  captor.driver.frame();
  captor.driver.drag({0, 0}, {30, -20});
  EXPECT_EQ(captor.dragged, (Point{30, -20}));
  EXPECT_EQ(captor.clicks[0], 0);
}

TEST(CapturedPointer, AButtonUnderWhichTheWheelIsTurnedIsNoClick) {
  Captor captor;
  captor.wants = true;
  captor.driver.frame();
  InputEvent event{.kind = EventKind::ButtonPressed};
  captor.driver.send({event});
  captor.driver.wheel({0, 0}, 1.0F);
  event.kind = EventKind::ButtonReleased;
  captor.driver.send({event});
  captor.driver.settle();
  EXPECT_EQ(captor.wheel, 1.0F);
  EXPECT_EQ(captor.clicks[0], 0);
}

TEST(CapturedPointer, IsFreeAgainWhereItWasCaught) {
  Captor captor;
  captor.driver.move_to({200, 150});
  captor.wants = true;
  captor.driver.frame();
  captor.driver.move_to({900, 900});
  captor.wants = false;
  captor.driver.frame();
  captor.driver.frame();
  EXPECT_EQ(captor.driver.ui().captured_by(), "");
  EXPECT_EQ(captor.driver.ui().pointer(), (Point{200, 150}));
  captor.driver.click("over");
  EXPECT_EQ(captor.presses, 1);
}

TEST(CapturedPointer, IsLostWithTheWindowsKeys) {
  Captor captor;
  captor.wants = true;
  captor.driver.frame();
  captor.wants = false;
  captor.driver.send({{.kind = EventKind::FocusLost}});
  captor.driver.frame();
  EXPECT_TRUE(captor.driver.ui().has_lost_keys() || captor.driver.ui().captured_by().empty());
  EXPECT_FALSE(captor.seen.is_captured && captor.seen.is_down[0]);
}

TEST(CapturedPointer, StaysFreeWhereTheWindowCannotCatchIt) {
  Captor captor(false);
  captor.wants = true;
  captor.driver.frame();
  captor.driver.frame();
  EXPECT_EQ(captor.driver.ui().captured_by(), "");
  captor.driver.move_to({20, 20});
  EXPECT_TRUE(captor.seen.is_hovered);
  EXPECT_FALSE(captor.seen.is_captured);
}

}  // namespace
}  // namespace hallux::ui
