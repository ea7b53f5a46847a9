#include "ui/window/shell/shell.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/ui/widgets/driver.h"
#include "ui/widgets/controls/button.h"
#include "ui/widgets/controls/card.h"
#include "ui/widgets/controls/field.h"
#include "ui/window/shell/help.h"

namespace hallux::ui {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

using Events = std::vector<std::string>;

/// A screen that says when it comes and goes, with a way on and a reason to stay.
class PlainScreen : public Screen {
 public:
  PlainScreen(std::string name, Events& events, WindowChrome around = WindowChrome::Navigation)
      : name_(std::move(name)), events_(events), around_(around) {}

  GuideSection guide_section() const override { return GuideSection::Overview; }
  std::string_view navigation_id() const override { return "nav.home"; }
  WindowChrome surround() const override { return around_; }
  std::string_view why_not_leave() const override { return reason; }
  bool ask_before_leaving(Ui&) override { return asks; }
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
  bool asks = false;

 private:
  std::string name_;
  Events& events_;
  WindowChrome around_;
};

class ShellJourney : public testing::Test {
 protected:
  ShellJourney() {
    auto first = std::make_unique<PlainScreen>("first", events_);
    home_ = first.get();
    shell_.preferences().is_motion_reduced = true;
    shell_.push(std::move(first));
    shell_.set_visitor(
        Visitor{"Trainee 12",
                "Trainee",
                "12",
                0,
                {{"nav.home", "Home", Icon::Home}, {"nav.history", "History", Icon::History, 3}}});
    shell_.on_navigate([this](const std::string& id) { events_.push_back("to " + id); });
    shell_.on_sign_out([this] { events_.push_back("sign out"); });
    driver_.frame();
    driver_.settle();
  }

  Events events_;
  Shell shell_;
  PlainScreen* home_ = nullptr;
  const Texts texts_ = english_texts();
  Driver driver_{texts_, [this](Ui& ui) { shell_.draw(ui); }};
};

/// What stands in front of everything.
class PlainLock : public Screen {
 public:
  GuideSection guide_section() const override { return GuideSection::Overview; }
  void draw(Ui& ui, const Rect& content, Shell& shell) override {
    if (button(ui, "lock.open", {content.x + 32.0F, 120.0F, 160.0F, 38.0F}, {"Open"}))
      shell.unlock();
  }
};

TEST_F(ShellJourney, ALockStandsInFrontOfAllAndChangesNothing) {
  events_.clear();
  shell_.lock(std::make_unique<PlainLock>());
  driver_.frame();
  driver_.settle();
  EXPECT_THAT(events_, ElementsAre("leave first"));
  EXPECT_FALSE(driver_.sees("first"));
  EXPECT_FALSE(driver_.has("nav.history"));
  driver_.press(Key::Digit2, {.control = true});
  driver_.press(Key::F1);
  driver_.press(Key::Escape);
  EXPECT_THAT(events_, ElementsAre("leave first"));
  // What work that ends meanwhile brings up is not seen before.
  shell_.push(std::make_unique<PlainScreen>("second", events_));
  driver_.frame();
  EXPECT_FALSE(driver_.sees("second"));
  driver_.click("lock.open");
  EXPECT_FALSE(shell_.is_locked());
  EXPECT_TRUE(driver_.sees("second"));
}

TEST_F(ShellJourney, WhoTouchesNothingIsIdle) {
  int idle = 0;
  shell_.on_idle(60.0, [&] { ++idle; });
  driver_.move_to({40.0F, 40.0F});
  driver_.wait(50.0);
  driver_.press(Key::Tab);
  driver_.wait(50.0);
  EXPECT_EQ(idle, 0);
  driver_.frame(11.0);
  EXPECT_GE(idle, 1);
  idle = 0;
  driver_.click("nav.person");
  driver_.click("person.4");
  EXPECT_EQ(idle, 1) << "who goes away may lock it at once";
  shell_.set_visitor(std::nullopt);
  idle = 0;
  driver_.frame(1000.0);
  EXPECT_EQ(idle, 0) << "nobody is there to be locked out";
}

TEST_F(ShellJourney, ScreensComeAndGoInOrder) {
  driver_.press(Key::Enter);
  EXPECT_TRUE(driver_.sees("second"));
  EXPECT_EQ(shell_.depth(), 2U);
  driver_.press(Key::Escape);
  EXPECT_TRUE(driver_.sees("first"));
  driver_.press(Key::Escape);
  EXPECT_EQ(shell_.depth(), 1U) << "the lowest stays";
  EXPECT_THAT(events_, ElementsAre("enter first", "leave first", "enter second", "leave second",
                                   "enter first"));
  shell_.replace_all(std::make_unique<PlainScreen>("third", events_));
  driver_.frame();
  driver_.settle();
  EXPECT_EQ(shell_.depth(), 1U);
  EXPECT_TRUE(driver_.sees("third"));
  EXPECT_THAT(driver_.faults(), IsEmpty());
}

TEST_F(ShellJourney, WhoIsSignedInIsSeenOnEveryScreen) {
  for (const WindowChrome around : {WindowChrome::Navigation, WindowChrome::Badge}) {
    shell_.replace_all(std::make_unique<PlainScreen>("other", events_, around));
    driver_.frame();
    driver_.settle();
    EXPECT_TRUE(driver_.sees("Trainee 12"));
    EXPECT_THAT(driver_.faults(), IsEmpty());
  }
}

/// A screen that can be opened from anywhere.
class ScreenOfNoPlace : public PlainScreen {
 public:
  using PlainScreen::PlainScreen;
  std::string_view navigation_id() const override { return {}; }
};

TEST_F(ShellJourney, AScreenOfNoPlaceBelongsWhereItWasOpenedFrom) {
  const auto is_lit = [&] { return driver_.widget("nav.home").is_chosen; };
  EXPECT_TRUE(is_lit());
  shell_.push(std::make_unique<ScreenOfNoPlace>("second", events_));
  driver_.frame();
  EXPECT_TRUE(driver_.has("second.on"));
  EXPECT_TRUE(is_lit());
  shell_.replace_all(std::make_unique<ScreenOfNoPlace>("third", events_));
  driver_.frame();
  EXPECT_FALSE(is_lit());
}

TEST_F(ShellJourney, NavigationByMouseAndByKeys) {
  driver_.click("nav.history");
  driver_.press(Key::Digit1, {.control = true});
  EXPECT_THAT(events_, ElementsAre("enter first", "to nav.history", "to nav.home"));
}

TEST_F(ShellJourney, AScreenThatMustStayRefusesWithItsReason) {
  home_->reason = "The attempt is still being recorded. Finish or abandon it.";
  driver_.click("nav.history");
  EXPECT_TRUE(driver_.sees("still being recorded"));
  driver_.press(Key::F1);
  EXPECT_FALSE(driver_.sees("Ctrl+1")) << "a way that leads nowhere is not offered";
  driver_.press(Key::Escape);
  driver_.click("nav.person");
  driver_.click("person.3");
  EXPECT_THAT(events_, ElementsAre("enter first"));
  EXPECT_THAT(driver_.faults(), IsEmpty());
  home_->reason.clear();
  driver_.click("nav.person");
  driver_.click("person.3");
  EXPECT_EQ(events_.back(), "sign out");
}

TEST_F(ShellJourney, TheWindowAsksWhetherItMayEnd) {
  EXPECT_TRUE(shell_.may_leave(driver_.ui()));
  home_->reason = "The attempt is still being recorded. Finish or abandon it.";
  EXPECT_FALSE(shell_.may_leave(driver_.ui()));
  EXPECT_FALSE(shell_.may_leave(driver_.ui()));
  driver_.frame();
  driver_.settle();
  EXPECT_TRUE(driver_.sees("still being recorded"));
  EXPECT_FALSE(driver_.has("message.0.close")) << "what is said again takes the place of the first";
  EXPECT_TRUE(driver_.has("message.1.close"));
}

TEST_F(ShellJourney, MessagesGoByThemselvesButFaultsStay) {
  driver_.click("first.note");
  EXPECT_TRUE(driver_.sees("Note saved"));
  driver_.wait(6.5);
  EXPECT_FALSE(driver_.sees("Note saved"));
  shell_.say({Meaning::Bad, "Arm does not answer", "Recording paused at 01:04", "Retry"});
  driver_.wait(60.0);
  EXPECT_TRUE(driver_.sees("Arm does not answer"));
  driver_.click("message.1.close");
  EXPECT_FALSE(driver_.sees("Arm does not answer"));
}

TEST_F(ShellJourney, AMessageCanBeTakenBack) {
  driver_.click("first.note");
  driver_.click("message.0.action");
  EXPECT_EQ(events_.back(), "undone");
  EXPECT_FALSE(driver_.sees("Note saved"));
}

TEST_F(ShellJourney, WhatWasSaidToOnePersonIsNotSaidToTheNext) {
  driver_.click("first.note");
  EXPECT_TRUE(driver_.sees("Note saved"));
  shell_.set_visitor(std::nullopt);
  driver_.frame();
  EXPECT_FALSE(driver_.sees("Note saved"));
}

TEST(Help, ListsEachThingOnceWithAllItsKeysAndTheMouse) {
  const Texts texts = english_texts();
  const std::vector<Shortcut> shortcuts{{{Key::Left}, "Lead the saw"},
                                        {with_shift(Key::Left), "Lead the saw"},
                                        {{Key::Space}, "Saw on or off"},
                                        {{Key::Right}, "Lead the saw"},
                                        {with_shift(Key::F9), "Swap the eyes"}};
  const std::vector<HelpRow> rows =
      help_rows(texts, shortcuts, {{"Move", "Lead the saw"}, {"Middle drag", "Turn the view"}});
  ASSERT_EQ(rows.size(), 4U);
  EXPECT_EQ(rows[0].label, "Lead the saw");
  EXPECT_THAT(rows[0].keys, ElementsAre("\xE2\x86\x90", "\xE2\x86\x92"))
      << "finer is no other thing";
  EXPECT_EQ(rows[0].mouse, "Move");
  EXPECT_THAT(rows[1].keys, IsEmpty()) << "the hand's movements stand before the switches";
  EXPECT_EQ(rows[1].mouse, "Middle drag");
  EXPECT_THAT(rows[2].keys, ElementsAre("Space"));
  EXPECT_EQ(rows[2].mouse, "");
  EXPECT_THAT(rows[3].keys, ElementsAre("Shift+F9"));
}

TEST_F(ShellJourney, HelpListsTheKeysAndCloses) {
  driver_.press(Key::F1);
  EXPECT_TRUE(driver_.sees("Full screen"));
  EXPECT_TRUE(driver_.sees("F11"));
  EXPECT_THAT(driver_.faults(), IsEmpty());
  driver_.press(Key::Escape);
  EXPECT_FALSE(driver_.sees("Full screen"));
}

TEST_F(ShellJourney, ALongListOfKeysIsReadByKeys) {
  driver_.resize(1280.0F, 260.0F);
  driver_.press(Key::F1);
  ASSERT_GT(driver_.widget("help.list").room_below, 0.0F);
  driver_.press(Key::End);
  EXPECT_EQ(driver_.widget("help.list").room_below, 0.0F);
  driver_.press(Key::PageUp);
  EXPECT_GT(driver_.widget("help.list").room_below, 0.0F);
}

TEST_F(ShellJourney, AQuestionBelowTheGuideIsSeen) {
  shell_.on_guide([](GuideSection) { return std::make_unique<PlainLock>(); });
  home_->reason = "Unsaved";
  home_->asks = true;
  driver_.press(Key::F1);
  driver_.press(Key::F1);
  ASSERT_TRUE(shell_.is_guide_shown());
  EXPECT_FALSE(shell_.may_leave(driver_.ui()));
  driver_.frame();
  EXPECT_FALSE(shell_.is_guide_shown());
}

TEST_F(ShellJourney, TheGuideIsToldOfItsSectionAndStaysUnderALock) {
  GuideSection asked = GuideSection::Inbox;
  shell_.on_guide([&](GuideSection section) {
    asked = section;
    return std::make_unique<PlainLock>();
  });
  driver_.press(Key::F1);
  driver_.click("help.guide");
  EXPECT_EQ(asked, GuideSection::Overview);
  shell_.lock(std::make_unique<PlainLock>());
  driver_.frame();
  driver_.click("lock.open");
  EXPECT_TRUE(shell_.is_guide_shown());
  driver_.press(Key::Plus, {.control = true});
  EXPECT_NEAR(driver_.ui().scale(), 1.1F, 1e-4F) << "the window's own keys work there";
}

TEST_F(ShellJourney, ScaleAndThemeFollowThePerson) {
  driver_.press(Key::Plus, {.control = true});
  driver_.press(Key::Plus, {.control = true});
  EXPECT_NEAR(driver_.ui().scale(), 1.2F, 1e-4F);
  for (int step = 0; step < 20; ++step) driver_.press(Key::Minus, {.control = true});
  EXPECT_NEAR(driver_.ui().scale(), 0.8F, 1e-4F);
  driver_.click("nav.person");
  driver_.click("person.0");
  EXPECT_EQ(driver_.ui().theme().name, ThemeName::Light);
  EXPECT_THAT(driver_.faults(), IsEmpty());
}

TEST_F(ShellJourney, RunningWorkIsSeenAndCancelled) {
  WorkEnd end = WorkEnd::Done;
  shell_.background().start(
      "Re-scoring 412 attempts",
      [](WorkReport& report) {
        while (report.reached(0.4)) std::this_thread::sleep_for(std::chrono::milliseconds(1));
      },
      [&](WorkEnd ended, const std::string&) { end = ended; });
  std::this_thread::sleep_for(std::chrono::milliseconds(350));
  driver_.frame();
  EXPECT_TRUE(driver_.sees("Re-scoring 412 attempts"));
  driver_.send(click_events(driver_.widget("work.0.cancel").visible.centre()));
  for (int step = 0; step < 2000 && !shell_.background().is_idle(); ++step) {
    driver_.frame();
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  EXPECT_EQ(end, WorkEnd::Cancelled);
  driver_.frame();
  EXPECT_FALSE(driver_.sees("Re-scoring 412 attempts"));
}

TEST_F(ShellJourney, ANarrowOrLargeWindowCutsNothingOff) {
  struct Size {
    float width, height, scale;
  };
  for (const Size& size :
       {Size{1280, 720, 1.0F}, {1280, 720, 2.0F}, {3840, 2160, 1.5F}, {1440, 900, 0.8F}}) {
    shell_.preferences().scale = size.scale;
    driver_.resize(size.width, size.height);
    driver_.press(Key::F1);
    EXPECT_THAT(driver_.faults(), IsEmpty()) << size.width;
    driver_.press(Key::Escape);
    EXPECT_THAT(driver_.faults(), IsEmpty()) << size.width;
  }
}

/// A page that is full to its last corner.
class FullScreen : public Screen {
 public:
  explicit FullScreen(WindowChrome around) : around_(around) {}
  GuideSection guide_section() const override { return GuideSection::Overview; }
  WindowChrome surround() const override { return around_; }
  void draw(Ui& ui, const Rect& content, Shell&) override {
    if (around_ == WindowChrome::Badge) {
      ui.area("full.view", "View", content);
      for (int panel = 0; panel < 4; ++panel)
        button(ui, "full.panel." + std::to_string(panel),
               {panel % 2 == 0 ? 20.0F : content.w - 320.0F, panel < 2 ? 20.0F : content.h - 80.0F,
                300.0F, 60.0F},
               {"Panel"});
      return;
    }
    const float offset = ui.begin_scroll("full.page", "Page", content, 4000.0F);
    for (int row = 0; row < 80; ++row)
      button(ui, "full.row." + std::to_string(row),
             {content.x, content.y - offset + 50.0F * static_cast<float>(row), content.w, 48.0F},
             {"Row"});
    ui.end_scroll();
  }

 private:
  WindowChrome around_;
};

TEST_F(ShellJourney, NoMessageCoversAControlOrAReadOut) {
  for (const WindowChrome around :
       {WindowChrome::Navigation, WindowChrome::Rail, WindowChrome::Badge}) {
    for (const auto& [width, height] :
         {std::pair{1440.0F, 900.0F}, {1280.0F, 720.0F}, {1024.0F, 640.0F}}) {
      shell_.replace_all(std::make_unique<FullScreen>(around));
      driver_.resize(width, height);
      for (int count = 0; count < 4; ++count)
        shell_.say({Meaning::Warn, "Message " + std::to_string(count),
                    "The backup was written to /srv/courses/autumn/backups/hallux.db", "Seen"});
      driver_.frame();
      driver_.settle();
      EXPECT_THAT(driver_.covered_by_messages(), IsEmpty())
          << width << " " << static_cast<int>(around);
      EXPECT_THAT(driver_.faults(), IsEmpty()) << width << " " << static_cast<int>(around);
      EXPECT_TRUE(driver_.sees("Message 3")) << "the newest is always there";
      for (int count = 0; count < 4; ++count) {
        for (const Widget& widget : std::vector<Widget>(driver_.content().widgets))
          if (widget.id.starts_with("message.") && widget.id.ends_with(".close")) {
            driver_.click(widget.id);
            break;
          }
        EXPECT_THAT(driver_.covered_by_messages(), IsEmpty()) << width << " " << count;
      }
      EXPECT_FALSE(driver_.sees("Message")) << "who waited for room came, too";
    }
  }
}

TEST_F(ShellJourney, AMessageMakesRoomForAMenu) {
  shell_.say({Meaning::Bad, "Arm does not answer", "Recording paused at 01:04"});
  driver_.frame();
  driver_.settle();
  driver_.click("nav.person");
  driver_.frame();
  driver_.settle();
  const Rect told = driver_.widget("message.0").visible;
  for (int item = 0; item < 5; ++item)
    EXPECT_TRUE(
        intersection(told, driver_.widget("person." + std::to_string(item)).visible).is_empty());
}

TEST_F(ShellJourney, ALongNameIsCutAndToldWholeOnHover) {
  const std::string name(120, 'W');
  shell_.set_visitor(Visitor{name, "Trainee", "W", 0, {{"nav.home", "Home", Icon::Home}}});
  shell_.replace_all(std::make_unique<FullScreen>(WindowChrome::Badge));
  driver_.resize(800.0F, 600.0F);
  driver_.settle();
  const auto badge = [&]() -> const SeenText* {
    for (const SeenText& seen : driver_.content().texts)
      if (seen.whole == name && seen.layer == Layer::Page) return &seen;
    return nullptr;
  };
  ASSERT_NE(badge(), nullptr);
  EXPECT_LE(badge()->rect.w, 200.0F);
  driver_.move_to(badge()->rect.centre());
  driver_.wait(1.0);
  std::string told;
  for (const SeenText& seen : driver_.content().texts)
    if (seen.layer == Layer::Tooltip) told += seen.text;
  EXPECT_EQ(told, name);
  EXPECT_THAT(driver_.faults(), IsEmpty());
}

}  // namespace
}  // namespace hallux::ui
