#include "ui/widgets/controls/dialog.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/ui/widgets/driver.h"
#include "ui/widgets/controls/field.h"

namespace hallux::ui {
namespace {

using testing::IsEmpty;

/// A dialog over a page with one button.
struct Asked {
  explicit Asked(const DriverSetting& setting = {})
      : driver(
            texts, [this](Ui& ui) { draw(ui); }, setting) {}

  void draw(Ui& ui) {
    button(ui, "page.below", {20.0F, 20.0F, 120.0F, button_height}, {"Below"});
    if (opener && ui.shortcut({*opener}, "Pin a note")) answer = Answer::Waiting;
    if (answer != Answer::Waiting) return;
    shown.title = "Pin a note";
    shown.sentence = "The note stands at 00:12, at the place that you marked on the bone.";
    shown.act = "Pin note";
    shown.keep = keep;
    shown.form_height = field_label_height + 300.0F;
    answer = dialog(ui, "pin", shown, [&](const Rect& form) {
      FieldSpec spec;
      spec.label = "Your note";
      spec.lines = lines;
      const float height = lines > 1 ? 96.0F : field_height;
      field(ui, "pin.words", {form.x, form.y + field_label_height, form.w, height}, words, spec);
      ui.focus_first("pin.words");
      button(ui, "pin.last", {form.x, form.bottom() - button_height, 120.0F, button_height},
             {"Last field"});
      return std::string_view(words.empty() ? "Write a note first" : "");
    });
  }

  const Texts texts = english_texts();
  Dialog shown;
  std::string words;
  std::string_view keep = "Cancel";
  int lines = 4;
  std::optional<Key> opener = std::nullopt;
  Answer answer = Answer::Waiting;
  Driver driver;
};

TEST(Dialog, TakesTheFocusAndActsByControlEnter) {
  Asked asked;
  asked.driver.press(Key::Enter, {.control = true});
  EXPECT_EQ(asked.answer, Answer::Waiting) << "nothing was written yet";
  EXPECT_EQ(asked.driver.widget("pin.act").why_off, "Write a note first");
  asked.driver.type("Look along the blade");
  asked.driver.press(Key::Enter, {.control = true});
  EXPECT_EQ(asked.answer, Answer::Act);
  EXPECT_EQ(asked.words, "Look along the blade");
}

TEST(Dialog, InAFieldOfOneLineEnterIsTheVerb) {
  Asked asked;
  asked.lines = 1;
  asked.driver.frame();
  asked.driver.type("Trainee 12");
  asked.driver.press(Key::Enter);
  EXPECT_EQ(asked.answer, Answer::Act);
  EXPECT_EQ(asked.words, "Trainee 12");
}

TEST(Dialog, WithoutAWayOutThereIsTheVerbAlone) {
  Asked asked;
  asked.keep = "";
  asked.shown.act_name = "done";
  asked.driver.frame();
  EXPECT_FALSE(asked.driver.has("pin.keep"));
  EXPECT_FALSE(asked.driver.has("pin.act"));
  EXPECT_TRUE(asked.driver.has("pin.done"));
  asked.driver.press(Key::Escape);
  EXPECT_EQ(asked.answer, Answer::Keep);
}

TEST(Dialog, InALowWindowTheButtonsStayAndAllElseScrolls) {
  Asked asked({640.0F, 360.0F, 1.0F});
  asked.shown.error = "The note could not be kept: it lies behind the end of the attempt.";
  asked.driver.frame();
  asked.driver.settle();
  const Rect window{0.0F, 0.0F, 640.0F, 360.0F};
  for (const char* id : {"pin.act", "pin.keep"})
    EXPECT_TRUE(window.encloses(asked.driver.widget(id).rect)) << id;
  EXPECT_TRUE(asked.driver.widget("pin.last").visible.is_empty());
  asked.driver.type("Half a note");
  asked.driver.press(Key::Tab);
  asked.driver.frame();
  EXPECT_EQ(asked.driver.focused(), "pin.last");
  EXPECT_FALSE(asked.driver.widget("pin.last").visible.is_empty()) << "it is brought into sight";
  EXPECT_THAT(asked.driver.faults(), IsEmpty());
}

TEST(Dialog, TheLetterOfTheKeyThatOpenedItIsNoText) {
  Asked asked;
  asked.answer = Answer::Keep;
  asked.opener = Key::C;
  asked.driver.frame();
  std::vector<InputEvent> events = key_events(Key::C);
  events.insert(events.begin() + 1, character_event(U'c'));
  asked.driver.send(events);
  asked.driver.settle();
  asked.driver.type("cut");
  EXPECT_EQ(asked.words, "cut");
}

TEST(Dialog, EscIsTheSafeAnswer) {
  Asked asked;
  asked.driver.type("Half a");
  asked.driver.press(Key::Escape);
  EXPECT_EQ(asked.answer, Answer::Keep);
}

TEST(Dialog, WhatLiesBelowCannotBeReached) {
  Asked asked;
  for (int presses = 0; presses < 8; ++presses) {
    asked.driver.press(Key::Tab);
    EXPECT_NE(asked.driver.focused(), "page.below");
  }
}

TEST(Dialog, SaysWhatWentWrongAndNothingIsCutOff) {
  for (const float scale : {0.8F, 1.0F, 1.5F, 2.0F}) {
    Asked asked({1280.0F, 720.0F, scale});
    asked.shown.error = "The note could not be kept: it lies behind the end of the attempt.";
    asked.driver.frame();
    EXPECT_TRUE(asked.driver.sees("The note could not be kept"));
    EXPECT_THAT(asked.driver.faults(), IsEmpty()) << scale;
    asked.driver.click("pin.last");  // scrolled to where there is little room
  }
}

}  // namespace
}  // namespace hallux::ui
