#include "ui/widgets/sheet.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/ui/widgets/driver.h"
#include "ui/widgets/field.h"

namespace hallux::ui {
namespace {

using testing::IsEmpty;

/// A page with one button; a sheet over it asks for a name.
struct SheetOverPage {
  explicit SheetOverPage(float width = 1280.0F, float height = 720.0F, float scale = 1.0F)
      : driver(texts, [this](Ui& ui) { draw(ui); }, {width, height, scale}) {}

  void draw(Ui& ui) {
    ui.canvas().fill(ui.display(), ui.theme().page);
    presses += button(ui, "page.below", {40.0F, 40.0F, 120.0F, button_height}, {"Below"}) ? 1 : 0;
    if (!is_shown) return;
    const Sheet sheet(ui, "sheet", {"A sheet", 480.0F, content_height});
    Rect rest = sheet.content();
    FieldSpec spec;
    spec.label = "Name";
    take_top(rest, field_label_height);
    field(ui, "sheet.name", take_top(rest, field_height, 12.0F), name, spec);
    ui.focus_first("sheet.name");
    const Rect last{sheet.content().x, sheet.content().bottom() - button_height, 120.0F,
                    button_height};
    saves += button(ui, "sheet.save", last, {"Save", ButtonLook::Primary}) ? 1 : 0;
    if (sheet.wants_close()) is_shown = false;
  }

  const Texts texts = english_texts();
  std::string name;
  float content_height = 180.0F;
  int presses = 0, saves = 0;
  bool is_shown = true;
  Driver driver;
};

TEST(Sheet, ItsFirstFieldHasTheFocusAndEnterIsItsPrimary) {
  SheetOverPage shown;
  shown.driver.type("Trainee 12");
  shown.driver.press(Key::Enter);
  EXPECT_EQ(shown.name, "Trainee 12");
  EXPECT_EQ(shown.saves, 1);
  EXPECT_THAT(shown.driver.faults(), IsEmpty());
}

TEST(Sheet, WhatLiesBelowCannotBeReached) {
  SheetOverPage shown;
  shown.driver.send(click_events({100.0F, 59.0F}));
  shown.driver.settle();
  for (int tab = 0; tab < 6; ++tab) {
    shown.driver.press(Key::Tab);
    EXPECT_NE(shown.driver.focused(), "page.below");
  }
  EXPECT_EQ(shown.presses, 0);
  EXPECT_TRUE(shown.is_shown);
}

TEST(Sheet, EscAndItsCloseBothCloseIt) {
  SheetOverPage by_key, by_mouse;
  by_key.driver.press(Key::Escape);
  EXPECT_FALSE(by_key.is_shown);
  by_mouse.driver.click("sheet.close");
  EXPECT_FALSE(by_mouse.is_shown);
  by_mouse.driver.click("page.below");
  EXPECT_EQ(by_mouse.presses, 1);
}

TEST(Sheet, ScrollsWhereTheWindowIsLower) {
  SheetOverPage shown(640.0F, 360.0F);
  shown.content_height = 900.0F;
  shown.driver.frame();
  shown.driver.settle();
  EXPECT_TRUE(shown.driver.widget("sheet.save").visible.is_empty());
  shown.driver.press(Key::Tab);  // the save button is the next stop
  shown.driver.frame();
  EXPECT_EQ(shown.driver.focused(), "sheet.save");
  EXPECT_FALSE(shown.driver.widget("sheet.save").visible.is_empty()) << "it is brought into sight";
  EXPECT_THAT(shown.driver.faults(), IsEmpty());
}

TEST(Sheet, CutsNothingOffAtAnyScale) {
  for (const float scale : {0.8F, 1.0F, 1.5F, 2.0F}) {
    SheetOverPage shown(1280.0F, 720.0F, scale);
    EXPECT_THAT(shown.driver.faults(), IsEmpty()) << scale;
  }
}

/// A short list inside a page that is lower than its content.
struct ListInPage {
  void draw(Ui& ui) {
    const float page = ui.begin_scroll("page", "Page", {0.0F, 0.0F, 600.0F, 300.0F}, 900.0F);
    const Rect view{20.0F, 500.0F - page, 400.0F, 160.0F};
    const float list = ui.begin_scroll("list", "List", view, 400.0F);
    for (int row = 0; row < 10; ++row)
      button(ui, "row." + std::to_string(row),
             {24.0F, view.y - list + 40.0F * static_cast<float>(row) + 4.0F, 200.0F, 32.0F},
             {"Row"});
    ui.end_scroll();
    ui.end_scroll();
  }
};

TEST(Scroll, ARegionInsideAnotherIsBroughtIntoSightWithTheFocus) {
  const Texts texts = english_texts();
  ListInPage page;
  Driver driver(texts, [&](Ui& ui) { page.draw(ui); }, {600.0F, 300.0F, 1.0F});
  for (int tab = 0; tab < 10; ++tab) {
    driver.press(Key::Tab);
    driver.frame();
    driver.frame();
    EXPECT_FALSE(driver.widget("row." + std::to_string(tab)).visible.is_empty()) << tab;
  }
}

}  // namespace
}  // namespace hallux::ui
