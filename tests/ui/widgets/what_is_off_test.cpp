// What is off says why, whatever kind of control it is.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>

#include "tests/ui/widgets/driver.h"
#include "ui/widgets/controls/button.h"
#include "ui/widgets/controls/choice.h"
#include "ui/widgets/controls/field.h"
#include "ui/widgets/controls/menu.h"

namespace hallux::ui {
namespace {

using testing::IsEmpty;

/// One control of each kind, off for a reason of its own.
void draw_what_is_off(Ui& ui) {
  std::string text;
  bool is_on = false;
  button(ui, "button", {10, 10, 200, 38}, {.label = "Send", .why_off = "no words"});
  icon_button(ui, "icon", {10, 110, 36, 36},
              {.label = "Earlier", .icon = Icon::Left, .why_off = "nothing before"});
  field(ui, "field", {10, 210, 200, 42}, text, {.label = "Name", .why_off = "no person"});
  checkbox(ui, "box", {10, 310, 200, 24}, "Hidden", is_on, true, "no files");
  toggle(ui, "toggle", {10, 410, 200, 24}, "Plan", is_on, true, "no plan");
}

void expect_reason_on_hover(Driver& driver, const std::string& id, const std::string& words) {
  EXPECT_FALSE(driver.widget(id).is_enabled) << id;
  EXPECT_FALSE(driver.sees(words)) << id;
  driver.move_to(driver.widget(id).rect.centre());
  driver.wait(1.0);
  EXPECT_TRUE(driver.sees(words)) << id;
}

TEST(WhatIsOff, SaysWhyOnHover) {
  const Texts english = english_texts();
  Driver page(english, draw_what_is_off);
  expect_reason_on_hover(page, "button", "no words");
  expect_reason_on_hover(page, "icon", "Earlier: nothing before");
  expect_reason_on_hover(page, "field", "no person");
  expect_reason_on_hover(page, "box", "no files");
  expect_reason_on_hover(page, "toggle", "no plan");
  EXPECT_THAT(page.faults(), IsEmpty());
}

TEST(WhatIsOff, SaysWhyToWhoHasNoPointer) {
  const Texts english = english_texts();
  Driver page(english, draw_what_is_off);
  for (const auto& [id, words] :
       std::array<std::pair<const char*, const char*>, 5>{{{"button", "no words"},
                                                           {"icon", "Earlier: nothing before"},
                                                           {"field", "no person"},
                                                           {"box", "no files"},
                                                           {"toggle", "no plan"}}}) {
    EXPECT_FALSE(page.sees(words)) << id;
    page.press(Key::Tab);
    EXPECT_EQ(page.focused(), id);
    EXPECT_TRUE(page.sees(words)) << id;
    EXPECT_THAT(page.faults(), IsEmpty());
  }
}

TEST(WhatIsOff, DoesNothingWhenItIsPressedOrWrittenInto) {
  const Texts english = english_texts();
  std::string text;
  bool is_on = false;
  int presses = 0, primary = 0;
  Driver page(english, [&](Ui& ui) {
    presses += button(ui, "button", {10, 10, 200, 38}, {.label = "Send", .why_off = "no words"});
    field(ui, "field", {10, 110, 200, 42}, text, {.label = "Name", .why_off = "no person"});
    toggle(ui, "toggle", {10, 210, 200, 24}, "Plan", is_on, true, "no plan");
    primary += button(ui, "go", {10, 310, 200, 38}, {"Go on", ButtonLook::Primary});
  });
  for (const char* id : {"button", "field", "toggle"}) {
    page.press(Key::Tab);
    ASSERT_EQ(page.focused(), id);
    page.type("ab");
    page.press(Key::Space);
    EXPECT_EQ(page.focused(), id);
  }
  EXPECT_EQ(presses, 0);
  EXPECT_EQ(text, "");
  EXPECT_FALSE(is_on);
  page.press(Key::Enter);
  EXPECT_EQ(primary, 0) << "Enter is for what has the ring";
}

TEST(WhatIsOff, LeavesTheFocusWhereItIsWhenThePointerPressesIt) {
  const Texts english = english_texts();
  std::string text;
  Driver page(english, [&](Ui& ui) {
    field(ui, "field", {10, 110, 200, 42}, text, {.label = "Name"});
    button(ui, "button", {10, 210, 200, 38}, {.label = "Send", .why_off = "no words"});
  });
  page.click("field");
  page.send(click_events(page.widget("button").rect.centre()));
  page.settle();
  EXPECT_EQ(page.focused(), "field");
}

TEST(WhatIsOff, KeepsTheFocusOfWhoPressedIt) {
  const Texts english = english_texts();
  std::string_view why;
  Driver page(english, [&](Ui& ui) {
    ButtonSpec newer{"Newer"};
    newer.why_off = why;
    if (button(ui, "newer", {10, 10, 120, 38}, newer)) why = "These are the newest.";
    button(ui, "older", {210, 10, 120, 38}, {"Older"});
  });
  page.press(Key::Tab);
  page.press(Key::Enter);
  EXPECT_EQ(page.focused(), "newer");
  EXPECT_TRUE(page.sees("These are the newest."));
}

TEST(WhatIsOff, SaysWhyInAMenu) {
  const Texts english = english_texts();
  const std::array<MenuItem, 1> items{{{.label = "Erase", .why_off = "nobody chosen"}}};
  Driver driver(english, [&](Ui& ui) { menu(ui, "menu", {400, 10}, items); });
  EXPECT_EQ(driver.focused(), "menu.0");
  driver.press(Key::Down);
  EXPECT_TRUE(driver.sees("nobody chosen")) << "where an arrow leads to it";
}

TEST(WhatIsOff, IsAFaultWithoutAReason) {
  const Texts english = english_texts();
  Driver driver(english, [](Ui& ui) {
    ui.control({.id = "mute", .label = "Mute", .rect = {10, 10, 100, 38}, .is_enabled = false});
  });
  EXPECT_THAT(driver.faults(), testing::ElementsAre("off without a reason: mute"));
}

TEST(WhatIsOff, IsPressedOnceTheReasonIsGone) {
  const Texts english = english_texts();
  int presses = 0;
  std::string_view why = "Saw the cut first.";
  Driver driver(english, [&](Ui& ui) {
    ButtonSpec take{"Take it out"};
    take.why_off = why;
    presses += button(ui, "take", {10, 10, 120, 38}, take);
  });
  EXPECT_FALSE(driver.widget("take").is_enabled);
  EXPECT_EQ(driver.widget("take").why_off, "Saw the cut first.");
  driver.move_to({30, 30});
  driver.wait(1.5);
  EXPECT_TRUE(driver.sees("Saw the cut first."));
  why = {};
  driver.frame();
  driver.click("take");
  EXPECT_EQ(presses, 1);
}

}  // namespace
}  // namespace hallux::ui
