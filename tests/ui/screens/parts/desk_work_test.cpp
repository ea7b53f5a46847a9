#include "ui/screens/parts/desk_work.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "simulator/base/progress.h"
#include "tests/ui/screens/some_visitor.h"

namespace hallux::ui {
namespace {

/// A screen whose only business is one piece of work.
class WorkingScreen : public Screen {
 public:
  using Act = std::function<int(database::Session&, WorkReport&)>;

  WorkingScreen(std::shared_ptr<SignedInSession> signed_in, Act act)
      : signed_in_(std::move(signed_in)), act_(std::move(act)) {}
  GuideSection guide_section() const override { return GuideSection::Overview; }
  void draw(Ui&, const Rect&, Shell& shell) override {
    if (std::exchange(is_begun_, true)) return;
    work_.start<int>(shell, signed_in_, {"Working", "It did not go", "It was stopped"}, act_,
                     [this](int& result) { done_ = result; });
  }
  int done() const { return done_; }
  const DeskWork& work() const { return work_; }

 private:
  std::shared_ptr<SignedInSession> signed_in_;
  Act act_;
  DeskWork work_;
  bool is_begun_ = false;
  int done_ = 0;
};

struct Working {
  explicit Working(WorkingScreen::Act act, const std::function<void(Shell&)>& meanwhile = {}) {
    auto made = std::make_unique<WorkingScreen>(visit_of(course, "root"), std::move(act));
    screen = made.get();
    shell.push(std::move(made));
    driver.frame();
    if (meanwhile) meanwhile(shell);
    while (!shell.background().is_idle()) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      driver.frame();
    }
    driver.settle();
  }

  database::SomeCourse course;
  Shell shell;
  const Texts texts = english_texts();
  Driver driver{texts, [this](Ui& ui) { shell.draw(ui); }};
  WorkingScreen* screen = nullptr;
};

void wait_for_cancel(WorkReport& report) {
  while (report.reached(0.5)) std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

void cancel_all(Shell& shell) {
  shell.background().cancel(shell.background().running().front().id);
}

TEST(DeskWork, WhatWasDoneIsToldToTheScreen) {
  Working working([](database::Session& session, WorkReport&) {
    return static_cast<int>(administrator_of(session).people().size());
  });
  EXPECT_EQ(working.screen->done(), 7);
  EXPECT_EQ(working.screen->work().fault(), "");
}

TEST(DeskWork, AFaultIsSaidAsASentence) {
  Working working([](database::Session& session, WorkReport&) {
    administrator_of(session).set_disabled("nobody", true);
    return 1;
  });
  EXPECT_EQ(working.screen->done(), 0);
  EXPECT_TRUE(working.driver.sees("It did not go"));
  EXPECT_TRUE(working.screen->work().fault().starts_with("There is no person 'nobody'"));
  EXPECT_EQ(working.screen->work().fault().back(), '.');
}

TEST(DeskWork, WhatWasStoppedIsSaid) {
  Working working(
      [](database::Session&, WorkReport& report) -> int {
        wait_for_cancel(report);
        throw Cancelled("stopped");
      },
      cancel_all);
  EXPECT_EQ(working.screen->done(), 0);
  EXPECT_TRUE(working.driver.sees("It was stopped"));
}

TEST(DeskWork, WhatWasDoneBeforeCancelStoppedItCounts) {
  Working working(
      [](database::Session&, WorkReport& report) {
        wait_for_cancel(report);
        return 5;
      },
      cancel_all);
  EXPECT_EQ(working.screen->done(), 5) << "a code that was issued is shown, not lost";
}

}  // namespace
}  // namespace hallux::ui
