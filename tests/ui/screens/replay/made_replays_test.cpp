#include "ui/screens/replay/made_replays.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "simulator/base/progress.h"
#include "tests/ui/screens/every_size.h"
#include "tests/ui/screens/some_reviewer.h"
#include "ui/screens/replay/replay_screen.h"

namespace hallux::ui {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;

/// Counts what is made: ada's attempt, as if a hand had made it.
struct CountedReplays {
  OperatedCourse operated;
  std::shared_ptr<SignedInSession> ada = visit_of(operated.course, "ada");
  int made = 0;
  bool is_stopped = false;
  std::shared_ptr<MadeReplays> replays = std::make_shared<MadeReplays>(
      [this](const auto&, const auto&, WorkReport& report) { return make(report); });

  std::shared_ptr<const ReplayMaterial> make(WorkReport& report) {
    ++made;
    if (is_stopped) throw Cancelled();
    auto copy = std::make_shared<ReplayMaterial>(*load_replay(*ada, operated.attempt, report));
    copy->header = {};
    copy->rights = {};
    copy->seen = {};
    return copy;
  }
  std::shared_ptr<const ReplayMaterial> ask() {
    WorkReport report;
    return replays->find_or_make(operated.operation.scenario, *ada, report);
  }
  /// Over a screen, so that there is one to come back to.
  std::unique_ptr<SomeVisitor> watch(float scale = 1.0F) {
    auto visitor = std::make_unique<SomeVisitor>(screen(), scale);
    visitor->finish_work();
    return visitor;
  }
  std::unique_ptr<Screen> screen() {
    return std::make_unique<ReplayScreen>(ada, replays, operated.operation.scenario);
  }
};

TEST(MadeReplays, AreMadeOnceAndKept) {
  CountedReplays counted;
  const auto first = counted.ask();
  EXPECT_EQ(counted.ask(), first);
  EXPECT_EQ(counted.made, 1);
}

TEST(MadeReplays, WhatWasStoppedIsMadeAnew) {
  CountedReplays counted;
  counted.is_stopped = true;
  EXPECT_THROW(counted.ask(), Cancelled);
  counted.is_stopped = false;
  EXPECT_NE(counted.ask(), nullptr);
  EXPECT_EQ(counted.made, 2);
}

TEST(MadeReplays, NobodyIsShownOneWhileTheirAssessmentIsRecorded) {
  CountedReplays counted;
  database::NewAttempt begun = counted.operated.course.attempt_of("ada");
  begun.kind = database::AttemptKind::Practice;
  const auto practice = counted.operated.course.trainee("ada").begin_attempt(begun);
  EXPECT_NE(counted.ask(), nullptr) << "a practice hides nothing";
  begun.kind = database::AttemptKind::Assessment;
  const auto assessment = counted.operated.course.trainee("ada").begin_attempt(begun);
  EXPECT_EQ(database::kind_thrown([&] { counted.ask(); }), database::DatabaseErrorKind::Refused);
}

TEST(MadeReplays, AreShownWithTheirForcesAndSaidToBeSimulated) {
  CountedReplays counted;
  const auto visitor = counted.watch();
  Driver& driver = visitor->driver();
  for (const char* words :
       {"Simulated expert hand", "Not surgeon-reviewed", "Nobody's attempt", "Force", "Events"}) {
    EXPECT_THAT(all_text(driver), HasSubstr(words));
  }
  EXPECT_TRUE(driver.has("replay.timeline"));
  EXPECT_TRUE(driver.has("replay.event.0"));
  driver.click("replay.tab.0");
  EXPECT_TRUE(driver.has("replay.ledger.A1"));
  EXPECT_THAT(driver.faults(), IsEmpty());
}

TEST(MadeReplays, NothingIsNotedOrAskedAboutThem) {
  CountedReplays counted;
  const auto visitor = counted.watch();
  Driver& driver = visitor->driver();
  for (const char* id : {"replay.flag", "replay.pin", "replay.tab.2", "notes.list"})
    EXPECT_FALSE(driver.has(id)) << id;
  driver.press(Key::F);
  driver.press(Key::C);
  EXPECT_FALSE(driver.has("question.words"));
  EXPECT_FALSE(driver.has("pin.words"));
  EXPECT_THAT(all_text(driver), Not(HasSubstr("not recorded")));
  EXPECT_THAT(counted.operated.course.trainee("ada").attempts(), SizeIs(1)) << "none is stored";
}

TEST(MadeReplays, ShowTheForceInALowWindowAndNoLineOfNotes) {
  CountedReplays counted;
  const auto visitor = counted.watch(1.5F);
  visitor->driver().resize(1280.0F, 720.0F);
  visitor->finish_work();
  const std::string shown = all_text(visitor->driver());
  for (const char* words : {"Steps", "Events", "Force"}) EXPECT_THAT(shown, HasSubstr(words));
  EXPECT_THAT(shown, Not(HasSubstr("Notes"))) << "nobody can write one";
  EXPECT_THAT(visitor->driver().faults(), IsEmpty());
}

TEST(MadeReplays, AreLeftForTheScreenBelowByMouseAndByKeyboard) {
  CountedReplays counted;
  for (const bool is_by_mouse : {true, false}) {
    SomeVisitor visitor(counted.screen());
    visitor.shell().push(counted.screen());
    visitor.driver().settle();
    visitor.finish_work();
    ASSERT_EQ(visitor.shell().depth(), 2U);
    if (is_by_mouse) {
      visitor.driver().click("replay.back");
    } else {
      press_by_keyboard(visitor, "replay.back");
    }
    EXPECT_EQ(visitor.shell().depth(), 1U) << is_by_mouse;
  }
}

TEST(MadeReplays, OneThatWasStoppedSaysSoAndIsAskedForAgain) {
  CountedReplays counted;
  counted.is_stopped = true;
  const auto visitor = counted.watch();
  EXPECT_TRUE(visitor->driver().has("replay.back"));
  EXPECT_TRUE(visitor->driver().has("replay.failed.action"));
  counted.is_stopped = false;
  visitor->driver().click("replay.failed.action");
  visitor->finish_work();
  EXPECT_TRUE(visitor->driver().has("replay.timeline"));
}

TEST(MadeReplays, AreCutOffAtNoScaleOrSize) {
  CountedReplays counted;
  counted.ask();
  EXPECT_THAT(faults_at_every_size([&] { return counted.screen(); }), IsEmpty());
}

}  // namespace
}  // namespace hallux::ui
