#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sqlite3.h>

#include <ostream>

#include "database/maintenance/verify.h"
#include "database/recording/recordings.h"
#include "tests/support/faulty_vfs.h"
#include "tests/ui/screens/operating/full_memory.h"
#include "tests/ui/screens/operating/some_operation.h"
#include "tests/ui/screens/some_visitor.h"
#include "ui/screens/guide/guide_screen.h"
#include "ui/screens/replay/replay_screen.h"

namespace hallux::ui {
namespace {

using database::AttemptKind;
using database::AttemptState;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr auto saw_bit = static_cast<std::uint32_t>(simulator::ToolStatus::SawOn);

InputEvent event_of(EventKind kind, Point position = {}) {
  InputEvent event;
  event.kind = kind;
  event.position = position;
  return event;
}

/// The words of the whole frame, whatever lines they were broken into.
std::string words_of(const Operator& person) {
  std::string words;
  for (const SeenText& text : person.driver().content().texts) words += text.text + " ";
  return words;
}

struct Failure {
  const char* name;
  int code;
  const char* words;

  friend void PrintTo(const Failure& failure, std::ostream* stream) { *stream << failure.words; }
};

class StorageFailsWhileOperating : public testing::TestWithParam<Failure> {};

TEST_P(StorageFailsWhileOperating, TheAttemptEndsInterruptedAndNothingBeforeIsLost) {
  tests::FaultyVfs vfs{"while_operating"};
  OperableCourse course("silver", 1.5, vfs.name());
  const database::AttemptId older = course.course().recorded_by("ada");
  const simulator::Recording before = course.course().trainee("ada").recording(older);
  Operator person(course, AttemptKind::Practice);
  person.begin();
  const int writes_at_start = vfs.writes_done();
  ASSERT_TRUE(person.until([&] { return vfs.writes_done() > writes_at_start + 10; }))
      << "nothing is recorded";
  person.press(Key::Space);
  vfs.fail_after(0, GetParam().code);
  ASSERT_TRUE(person.until([&] { return person.driver().sees("The operation stopped"); }));
  EXPECT_THAT(words_of(person), HasSubstr(GetParam().words));
  EXPECT_THAT(words_of(person), HasSubstr("kept as an interrupted attempt"));
  EXPECT_THAT(person.driver().faults(), IsEmpty());
  EXPECT_TRUE(person.shell().top()->why_not_leave().empty()) << "nothing is recorded any more";
  vfs.heal();

  const database::AttemptHeader header = course.newest_attempt();
  EXPECT_EQ(header.state, AttemptState::Interrupted);
  EXPECT_NE(header.id.text, older.text);
  const simulator::Recording kept = course.course().trainee("ada").recording(header.id);
  EXPECT_FALSE(kept.samples.empty());
  EXPECT_EQ(kept.tape.size(), kept.samples.size());
  EXPECT_TRUE(database::is_same(course.course().trainee("ada").recording(older), before));
  EXPECT_TRUE(database::verify(course.course().database()).is_whole());

  person.click("operate.see_kept");
  EXPECT_TRUE(person.is_gone());
  EXPECT_THAT(person.navigator.asked, ElementsAre("replay " + header.id.text + " at 0.000000"));
  SomeVisitor looking(
      std::make_unique<ReplayScreen>(visit_of(course.course(), "ada"), header.id, 0.0));
  EXPECT_TRUE(looking.driver().has("replay.view"));
}

INSTANTIATE_TEST_SUITE_P(Operating, StorageFailsWhileOperating,
                         testing::Values(Failure{"ReadOnly", SQLITE_READONLY, "read-only"},
                                         Failure{"Broken", SQLITE_IOERR_WRITE, "check the disk"}),
                         [](const auto& tested) { return std::string(tested.param.name); });

/// An operation that records, on a disk that can be filled.
class OnAFullDisk : public testing::Test {
 protected:
  void SetUp() override {
    person_.begin();
    const int writes_at_start = vfs_.writes_done();
    ASSERT_TRUE(person_.until([&] { return vfs_.writes_done() > writes_at_start + 10; }))
        << "nothing is recorded";
    vfs_.fail_after(0, SQLITE_FULL);
    ASSERT_TRUE(person_.until([&] { return person_.driver().has("operate.full.stop"); }));
  }

  tests::FaultyVfs vfs_{"filled_while_operating"};
  OperableCourse course_{"silver", 1.5, vfs_.name()};
  Operator person_{course_, AttemptKind::Practice};
};

TEST_F(OnAFullDisk, TheOperationPausesSaysWhereAndGoesOnWhenThereIsRoom) {
  EXPECT_THAT(words_of(person_), HasSubstr("The disk is full"));
  EXPECT_THAT(words_of(person_), HasSubstr("nothing is lost"));
  EXPECT_THAT(person_.driver().faults(), IsEmpty());
  person_.press(Key::P);
  person_.make_frames(5);
  EXPECT_TRUE(person_.driver().has("operate.full.stop")) << "nobody goes on without room";
  vfs_.heal();
  ASSERT_TRUE(person_.until([&] { return person_.driver().has("operate.go_on"); }));
  EXPECT_THAT(words_of(person_), HasSubstr("room on the disk again"));
  person_.click("operate.go_on");
  person_.press(Key::End);
  person_.click("operate.ask_finish.act");
  ASSERT_TRUE(person_.until([&] { return person_.is_gone(); }));
  const database::AttemptHeader header = course_.attempt();
  EXPECT_EQ(header.state, AttemptState::Closed);
  EXPECT_TRUE(header.is_complete);
  EXPECT_TRUE(database::verify(course_.course().database()).is_whole());
}

TEST_F(OnAFullDisk, WhoStopsKeepsWhatWasSaved) {
  person_.click("operate.full.stop");
  ASSERT_TRUE(person_.until([&] { return person_.driver().sees("The operation stopped"); }));
  EXPECT_THAT(words_of(person_), HasSubstr("kept as an interrupted attempt"));
  EXPECT_THAT(person_.driver().faults(), IsEmpty());
  vfs_.heal();
  EXPECT_EQ(course_.attempt().state, AttemptState::Interrupted);
  EXPECT_FALSE(course_.course().trainee("ada").recording(course_.attempt().id).samples.empty());
}

TEST(OperatingFailures, ADiskThatIsFullBeforeItBeginsIsSaidAndAnAttemptCanBeBegunLater) {
  tests::FaultyVfs vfs{"before_it_begins"};
  OperableCourse course("silver", 1.5, vfs.name());
  {
    Operator person(course, AttemptKind::Practice);
    vfs.fail_after(0, SQLITE_FULL);
    person.press(Key::Enter);
    ASSERT_TRUE(person.until([&] { return person.driver().sees("The operation stopped"); }));
    EXPECT_THAT(words_of(person), HasSubstr("the disk is full"));
    EXPECT_FALSE(person.driver().has("operate.see_kept"));
    EXPECT_THAT(person.driver().faults(), IsEmpty());
    vfs.heal();
  }
  Operator person(course, AttemptKind::Practice);
  person.begin();
}

TEST(OperatingFailures, MemoryThatRunsOutEndsTheAttemptInterruptedAndSaysSo) {
  OperableCourse course("silver");
  Operator person(course, AttemptKind::Practice);
  person.begin();
  const auto recorded = [&] {
    return course.course().trainee("ada").recording(course.newest_attempt().id).samples.size();
  };
  ASSERT_TRUE(person.until([&] { return recorded() >= 500; }));
  {
    const tests::FullMemory full(4096);
    ASSERT_TRUE(person.until([&] { return person.driver().sees("The operation stopped"); }));
  }
  EXPECT_THAT(words_of(person), HasSubstr("The memory is full"));
  EXPECT_THAT(words_of(person), HasSubstr("kept as an interrupted attempt"));
  EXPECT_THAT(person.driver().faults(), IsEmpty());
  EXPECT_EQ(course.attempt().state, AttemptState::Interrupted);
  EXPECT_GE(recorded(), 500U);
}

/// Practice in which the saw runs in the air, led by the pointer.
class WithTheSawRunning : public testing::Test {
 protected:
  WithTheSawRunning() {
    person_.begin();
    move_to({600.0F, 500.0F});
    move_to({620.0F, 500.0F});
    person_.press(Key::Space);
    EXPECT_TRUE(person_.until([&] { return person_.scenes.saw->is_running; }));
  }

  void move_to(Point place) { person_.move_to(place); }

  /// The saw is off by the record, the loop is paused by the operator, and the screen says why.
  void expect_interrupted(const char* words) {
    EXPECT_TRUE(person_.driver().sees("Paused"));
    EXPECT_TRUE(person_.driver().sees(words));
    EXPECT_THAT(person_.driver().faults(), IsEmpty());
    EXPECT_TRUE(person_.until([&] { return !person_.scenes.saw->is_running; }));
    person_.press(Key::P);
    EXPECT_FALSE(person_.driver().sees("Paused"));
    for (int frame = 0; frame < 20; ++frame) {
      person_.until([frame_before = person_.scenes.pictures, this] {
        return person_.scenes.pictures > frame_before;
      });
      EXPECT_FALSE(person_.scenes.saw->is_running) << "it does not start by itself";
    }
    person_.close();
    const simulator::Recording kept =
        course_.course().trainee("ada").recording(course_.attempt().id);
    ASSERT_FALSE(kept.samples.empty());
    EXPECT_EQ(kept.samples.back().status & saw_bit, 0U);
  }

  OperableCourse course_{"silver"};
  Operator person_{course_, AttemptKind::Practice};
};

TEST_F(WithTheSawRunning, AWindowThatLosesTheKeyboardPauses) {
  person_.driver().send({event_of(EventKind::FocusLost)});
  person_.make_frames(2);
  expect_interrupted("Another window has the keyboard");
}

TEST_F(WithTheSawRunning, APointerThatLeavesTheWindowPauses) {
  person_.press(Key::C);
  move_to({640.0F, 500.0F});
  move_to({650.0F, 500.0F});
  person_.driver().send({event_of(EventKind::PointerLeft)});
  person_.make_frames(2);
  expect_interrupted("The pointer left the window");
}

TEST_F(WithTheSawRunning, AListOverThePicturePauses) {
  person_.press(Key::F1);
  person_.make_frames(2);
  person_.press(Key::Escape);
  expect_interrupted("Something lay over the picture");
}

TEST_F(WithTheSawRunning, TheGuideIsReadInThatPauseAndNothingIsLost) {
  person_.shell().on_guide(
      [](GuideSection section) { return std::make_unique<GuideScreen>(section); });
  person_.press(Key::F1);
  person_.make_frames(2);
  person_.press(Key::F1);
  person_.make_frames(2);
  ASSERT_TRUE(person_.shell().is_guide_shown());
  EXPECT_TRUE(person_.driver().sees("lead the saw, in the plane you look at"));
  // Its keys are the guide's.
  person_.press(Key::End);
  person_.press(Key::Space);
  person_.make_frames(2);
  EXPECT_TRUE(person_.shell().is_guide_shown());
  person_.press(Key::Escape);
  person_.make_frames(2);
  ASSERT_FALSE(person_.shell().is_guide_shown());
  expect_interrupted("Something lay over the picture");
}

TEST_F(WithTheSawRunning, TheGuidePausesAlsoWhereTheSawIsOff) {
  person_.shell().on_guide(
      [](GuideSection section) { return std::make_unique<GuideScreen>(section); });
  person_.press(Key::Space);
  person_.press(Key::F1);
  person_.make_frames(2);
  person_.press(Key::Escape);
  person_.make_frames(2);
  EXPECT_FALSE(person_.driver().sees("Something lay over the picture"))
      << "the list alone does not";
  person_.press(Key::F1);
  person_.make_frames(2);
  person_.press(Key::F1);
  person_.make_frames(2);
  person_.press(Key::Escape);
  person_.make_frames(2);
  expect_interrupted("Something lay over the picture");
}

TEST_F(WithTheSawRunning, AWindowThatStoodStillPauses) {
  person_.driver().frame(2.0);
  person_.make_frames(2);
  expect_interrupted("The window stood still");
}

/// Opens by itself with the next frame.
class BriefLock : public Screen {
 public:
  GuideSection guide_section() const override { return GuideSection::Overview; }
  void draw(Ui& /*ui*/, const Rect& /*content*/, Shell& shell) override { shell.unlock(); }
};

TEST_F(WithTheSawRunning, ALockPausesBeforeAnythingIsDrawn) {
  person_.shell().lock(std::make_unique<BriefLock>());
  EXPECT_TRUE(person_.shell().is_locked());
  person_.make_frames(3);
  expect_interrupted("The window was locked");
}

TEST_F(WithTheSawRunning, GoOnIsAButtonToo) {
  person_.driver().send({event_of(EventKind::FocusLost)});
  person_.make_frames(2);
  person_.click("operate.go_on");
  EXPECT_FALSE(person_.driver().sees("Paused"));
}

TEST_F(WithTheSawRunning, APointerThatLeavesWithTheSawOffDisturbsNobody) {
  person_.press(Key::Space);
  person_.driver().send({event_of(EventKind::PointerLeft)});
  person_.make_frames(2);
  EXPECT_FALSE(person_.driver().sees("Paused"));
}

TEST_F(WithTheSawRunning, AWindowThatIsClosedStopsTheSawAndAsks) {
  EXPECT_FALSE(person_.shell().may_leave(person_.driver().ui()));
  EXPECT_FALSE(person_.shell().may_leave(person_.driver().ui())) << "asked once";
  person_.make_frames(2);
  EXPECT_TRUE(person_.driver().has("operate.ask_leave.keep"));
  EXPECT_THAT(person_.driver().faults(), IsEmpty());
  EXPECT_TRUE(person_.until([&] { return !person_.scenes.saw->is_running; }));
  person_.click("operate.ask_leave.keep");
  EXPECT_FALSE(person_.driver().sees("Paused")) << "it goes on";
}

}  // namespace
}  // namespace hallux::ui
