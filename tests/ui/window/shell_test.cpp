#include "ui/window/shell/shell.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/ui/widgets/driver.h"
#include "ui/widgets/button.h"
#include "ui/widgets/card.h"
#include "ui/widgets/field.h"

namespace hallux::ui {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

using Events = std::vector<std::string>;

/// A screen that says when it comes and goes, with a way on and a reason to stay.
class PlainScreen : public Screen {
 public:
  PlainScreen(std::string name, Events& events, Surround around = Surround::Navigation)
      : name_(std::move(name)), events_(events), around_(around) {}

  std::string_view navigation_id() const override { return "nav.home"; }
  Surround surround() const override { return around_; }
  std::string_view why_not_leave() const override { return reason; }
  void enter(Shell&) override { events_.push_back("enter " + name_); }
  void leave(Shell&) override { events_.push_back("leave " + name_); }
  void draw(Ui& ui, const Rect& content, Shell& shell) override {
    page_title(ui, {content.x + 32.0F, 32.0F}, name_, "A plain screen.");
    if (button(ui, name_ + ".on", {content.x + 32.0F, 120.0F, 160.0F, 38.0F},
               {"Go on", ButtonLook::Primary}))
      shell.push(std::make_unique<PlainScreen>("second", events_));
    if (button(ui, name_ + ".note", {content.x + 32.0F, 180.0F, 160.0F, 38.0F}, {"Save note"}))
      shell.say({Meaning::Good, "Note saved", "Visible to Trainee 12", "Undo",
                 [this] { events_.push_back("undone"); }});
  }

  std::string reason;

 private:
  std::string name_;
  Events& events_;
  Surround around_;
};

class ShellJourney : public testing::Test {
 protected:
  ShellJourney() {
    auto first = std::make_unique<PlainScreen>("first", events);
    home = first.get();
    shell.preferences().is_motion_reduced = true;
    shell.push(std::move(first));
    shell.set_visitor(
        Visitor{"Trainee 12",
                "Trainee",
                "12",
                0,
                {{"nav.home", "Home", Icon::Home}, {"nav.history", "History", Icon::History, 3}}});
    shell.on_navigate([this](const std::string& id) { events.push_back("to " + id); });
    shell.on_sign_out([this] { events.push_back("sign out"); });
    driver.frame();
    driver.settle();
  }

  Events events;
  Shell shell;
  PlainScreen* home = nullptr;
  const Texts texts = english_texts();
  Driver driver{texts, [this](Ui& ui) { shell.draw(ui); }};
};

/// What stands in front of everything.
class PlainLock : public Screen {
 public:
  void draw(Ui& ui, const Rect& content, Shell& shell) override {
    if (button(ui, "lock.open", {content.x + 32.0F, 120.0F, 160.0F, 38.0F}, {"Open"}))
      shell.unlock();
  }
};

TEST_F(ShellJourney, ALockStandsInFrontOfAllAndChangesNothing) {
  events.clear();
  shell.lock(std::make_unique<PlainLock>());
  driver.frame();
  driver.settle();
  EXPECT_THAT(events, ElementsAre("leave first"));
  EXPECT_FALSE(driver.sees("first"));
  EXPECT_FALSE(driver.has("nav.history"));
  driver.press(Key::Digit2, {.control = true});
  driver.press(Key::F1);
  driver.press(Key::Escape);
  EXPECT_THAT(events, ElementsAre("leave first"));
  // What work that ends meanwhile brings up is not seen before.
  shell.push(std::make_unique<PlainScreen>("second", events));
  driver.frame();
  EXPECT_FALSE(driver.sees("second"));
  driver.click("lock.open");
  EXPECT_FALSE(shell.is_locked());
  EXPECT_TRUE(driver.sees("second"));
}

TEST_F(ShellJourney, WhoTouchesNothingIsIdle) {
  int idle = 0;
  shell.on_idle(60.0, [&] { ++idle; });
  driver.move_to({40.0F, 40.0F});
  driver.wait(50.0);
  driver.press(Key::Tab);
  driver.wait(50.0);
  EXPECT_EQ(idle, 0);
  driver.frame(11.0);
  EXPECT_GE(idle, 1);
  idle = 0;
  driver.click("nav.person");
  driver.click("person.4");
  EXPECT_EQ(idle, 1) << "who goes away may lock it at once";
  shell.set_visitor(std::nullopt);
  idle = 0;
  driver.frame(1000.0);
  EXPECT_EQ(idle, 0) << "nobody is there to be locked out";
}

TEST_F(ShellJourney, ScreensComeAndGoInOrder) {
  driver.press(Key::Enter);
  EXPECT_TRUE(driver.sees("second"));
  EXPECT_EQ(shell.depth(), 2U);
  driver.press(Key::Escape);
  EXPECT_TRUE(driver.sees("first"));
  driver.press(Key::Escape);
  EXPECT_EQ(shell.depth(), 1U) << "the lowest stays";
  EXPECT_THAT(events, ElementsAre("enter first", "leave first", "enter second", "leave second",
                                  "enter first"));
  shell.replace_all(std::make_unique<PlainScreen>("third", events));
  driver.frame();
  driver.settle();
  EXPECT_EQ(shell.depth(), 1U);
  EXPECT_TRUE(driver.sees("third"));
  EXPECT_THAT(driver.faults(), IsEmpty());
}

TEST_F(ShellJourney, WhoIsSignedInIsSeenOnEveryScreen) {
  for (const Surround around : {Surround::Navigation, Surround::Badge}) {
    shell.replace_all(std::make_unique<PlainScreen>("other", events, around));
    driver.frame();
    driver.settle();
    EXPECT_TRUE(driver.sees("Trainee 12"));
    EXPECT_THAT(driver.faults(), IsEmpty());
  }
}

/// A screen that can be opened from anywhere.
class ScreenOfNoPlace : public PlainScreen {
 public:
  using PlainScreen::PlainScreen;
  std::string_view navigation_id() const override { return {}; }
};

TEST_F(ShellJourney, AScreenOfNoPlaceBelongsWhereItWasOpenedFrom) {
  const auto is_lit = [&] { return driver.widget("nav.home").is_chosen; };
  EXPECT_TRUE(is_lit());
  shell.push(std::make_unique<ScreenOfNoPlace>("second", events));
  driver.frame();
  EXPECT_TRUE(driver.has("second.on"));
  EXPECT_TRUE(is_lit());
  shell.replace_all(std::make_unique<ScreenOfNoPlace>("third", events));
  driver.frame();
  EXPECT_FALSE(is_lit());
}

TEST_F(ShellJourney, NavigationByMouseAndByKeys) {
  driver.click("nav.history");
  driver.press(Key::Digit1, {.control = true});
  EXPECT_THAT(events, ElementsAre("enter first", "to nav.history", "to nav.home"));
}

TEST_F(ShellJourney, AScreenThatMustStayRefusesWithItsReason) {
  home->reason = "The attempt is still being recorded. Finish or abandon it.";
  driver.click("nav.history");
  EXPECT_TRUE(driver.sees("still being recorded"));
  driver.click("nav.person");
  driver.click("person.3");
  EXPECT_THAT(events, ElementsAre("enter first"));
  EXPECT_THAT(driver.faults(), IsEmpty());
  home->reason.clear();
  driver.click("nav.person");
  driver.click("person.3");
  EXPECT_EQ(events.back(), "sign out");
}

TEST_F(ShellJourney, TheWindowAsksWhetherItMayEnd) {
  EXPECT_TRUE(shell.may_leave(driver.ui()));
  home->reason = "The attempt is still being recorded. Finish or abandon it.";
  EXPECT_FALSE(shell.may_leave(driver.ui()));
  EXPECT_FALSE(shell.may_leave(driver.ui()));
  driver.frame();
  driver.settle();
  EXPECT_TRUE(driver.sees("still being recorded"));
  EXPECT_FALSE(driver.has("message.0.close")) << "what is said again takes the place of the first";
  EXPECT_TRUE(driver.has("message.1.close"));
}

TEST_F(ShellJourney, MessagesGoByThemselvesButFaultsStay) {
  driver.click("first.note");
  EXPECT_TRUE(driver.sees("Note saved"));
  driver.wait(6.5);
  EXPECT_FALSE(driver.sees("Note saved"));
  shell.say({Meaning::Bad, "Arm does not answer", "Recording paused at 01:04", "Retry"});
  driver.wait(60.0);
  EXPECT_TRUE(driver.sees("Arm does not answer"));
  driver.click("message.1.close");
  EXPECT_FALSE(driver.sees("Arm does not answer"));
}

TEST_F(ShellJourney, AMessageCanBeTakenBack) {
  driver.click("first.note");
  driver.click("message.0.action");
  EXPECT_EQ(events.back(), "undone");
  EXPECT_FALSE(driver.sees("Note saved"));
}

TEST_F(ShellJourney, WhatWasSaidToOnePersonIsNotSaidToTheNext) {
  driver.click("first.note");
  EXPECT_TRUE(driver.sees("Note saved"));
  shell.set_visitor(std::nullopt);
  driver.frame();
  EXPECT_FALSE(driver.sees("Note saved"));
}

TEST_F(ShellJourney, HelpListsTheKeysAndCloses) {
  driver.press(Key::F1);
  EXPECT_TRUE(driver.sees("Full screen"));
  EXPECT_TRUE(driver.sees("F11"));
  EXPECT_THAT(driver.faults(), IsEmpty());
  driver.press(Key::Escape);
  EXPECT_FALSE(driver.sees("Full screen"));
}

TEST_F(ShellJourney, ScaleAndThemeFollowThePerson) {
  driver.press(Key::Plus, {.control = true});
  driver.press(Key::Plus, {.control = true});
  EXPECT_NEAR(driver.ui().scale(), 1.2F, 1e-4F);
  for (int step = 0; step < 20; ++step) driver.press(Key::Minus, {.control = true});
  EXPECT_NEAR(driver.ui().scale(), 0.8F, 1e-4F);
  driver.click("nav.person");
  driver.click("person.0");
  EXPECT_EQ(driver.ui().theme().name, ThemeName::Light);
  EXPECT_THAT(driver.faults(), IsEmpty());
}

TEST_F(ShellJourney, RunningWorkIsSeenAndCancelled) {
  WorkEnd end = WorkEnd::Done;
  shell.background().start(
      "Re-scoring 412 attempts",
      [](WorkReport& report) {
        while (report.reached(0.4)) std::this_thread::sleep_for(std::chrono::milliseconds(1));
      },
      [&](WorkEnd ended, const std::string&) { end = ended; });
  std::this_thread::sleep_for(std::chrono::milliseconds(350));
  driver.frame();
  EXPECT_TRUE(driver.sees("Re-scoring 412 attempts"));
  driver.send(click_events(driver.widget("work.0.cancel").visible.centre()));
  for (int step = 0; step < 2000 && !shell.background().is_idle(); ++step) {
    driver.frame();
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  EXPECT_EQ(end, WorkEnd::Cancelled);
  driver.frame();
  EXPECT_FALSE(driver.sees("Re-scoring 412 attempts"));
}

TEST_F(ShellJourney, ANarrowOrLargeWindowCutsNothingOff) {
  struct Size {
    float width, height, scale;
  };
  for (const Size& size :
       {Size{1280, 720, 1.0F}, {1280, 720, 2.0F}, {3840, 2160, 1.5F}, {1440, 900, 0.8F}}) {
    shell.preferences().scale = size.scale;
    driver.resize(size.width, size.height);
    driver.press(Key::F1);
    EXPECT_THAT(driver.faults(), IsEmpty()) << size.width;
    driver.press(Key::Escape);
    EXPECT_THAT(driver.faults(), IsEmpty()) << size.width;
  }
}

}  // namespace
}  // namespace hallux::ui
