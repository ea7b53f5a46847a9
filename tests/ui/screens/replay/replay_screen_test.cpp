#include "ui/screens/replay/replay_screen.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/ui/screens/some_reviewer.h"

namespace hallux::ui {
namespace {

using database::AttemptId;
using database::SomeCourse;
using testing::IsEmpty;
using testing::SizeIs;

/// Somebody of the course who watches an attempt from a moment on.
struct Watcher : SomeReviewer {
  Watcher(SomeCourse& course, const std::string& login, const AttemptId& attempt,
          double moment_s = 0.0, float scale = 1.0F)
      : SomeReviewer(
            [&](SomeNavigator&) {
              return std::make_unique<ReplayScreen>(visit_of(course, login), attempt, moment_s);
            },
            scale) {}
  void press_bone() {
    const Rect view = driver().widget("replay.view").rect;
    const Point middle{view.mid_x() * driver().ui().scale(), view.mid_y() * driver().ui().scale()};
    driver().send(click_events(middle));
    driver().settle();
  }
};

TEST(ReplayScreen, BeginsAtTheMomentThatWasAskedFor) {
  OperatedCourse akin;
  Watcher watcher(akin.course, "ada", akin.attempt, 0.42);
  EXPECT_TRUE(watcher.driver().sees("00:00.4"));
  EXPECT_TRUE(watcher.driver().sees("Akin osteotomy, right hallux / Attempt 1"));
  EXPECT_TRUE(watcher.driver().sees("Not surgeon-reviewed"));
  EXPECT_THAT(watcher.driver().faults(), IsEmpty());
}

TEST(ReplayScreen, AnEventIsLookedAtByItsRow) {
  OperatedCourse akin;
  Watcher watcher(akin.course, "ada", akin.attempt);
  Driver& driver = watcher.driver();
  driver.click("replay.tab.2");
  EXPECT_TRUE(driver.sees("A piece was taken out"));
  driver.click("replay.event.2");  // the first blade entered, at 10 ms
  EXPECT_TRUE(driver.sees("The blade entered the bone"));
  driver.press(Key::N);
  EXPECT_TRUE(driver.sees("00:00.3")) << "the first cut was declared done";
}

TEST(ReplayScreen, ALedgerEntryIsLookedAtByKeyboard) {
  OperatedCourse akin;
  Watcher watcher(akin.course, "ada", akin.attempt, 0.7);
  Driver& driver = watcher.driver();
  watcher.tab_to("replay.tab");
  driver.press(Key::Right);
  driver.press(Key::Space);
  watcher.tab_to("replay.ledger");
  EXPECT_TRUE(driver.sees("00:00.7"));
  driver.press(Key::Enter);
  EXPECT_FALSE(driver.sees("00:00.7"));
}

TEST(ReplayScreen, ANoteIsPinnedToMomentAndBoneAndAnswered) {
  OperatedCourse akin;
  {
    Watcher instructor(akin.course, "kim", akin.attempt, 0.2);
    instructor.press_bone();
    instructor.driver().click("replay.pin");
    EXPECT_TRUE(instructor.driver().sees("at the place that you marked"));
    instructor.driver().type("Look along the blade.");
    instructor.driver().click("pin.act");
    instructor.finish();
    EXPECT_TRUE(instructor.driver().sees("Look along the blade."));
    EXPECT_TRUE(instructor.driver().sees("The note is pinned"));
    EXPECT_THAT(instructor.driver().faults(), IsEmpty());
  }
  const auto notes = akin.course.trainee("ada").notes(akin.attempt);
  ASSERT_THAT(notes, SizeIs(1));
  EXPECT_EQ(notes.front().moment.moment_us, 200'000);
  ASSERT_TRUE(notes.front().moment.place.has_value());
  {
    // The trainee answers with the keyboard alone.
    Watcher trainee(akin.course, "ada", akin.attempt);
    Driver& driver = trainee.driver();
    EXPECT_FALSE(driver.has("replay.pin"));
    trainee.tab_to("notes.note.1");
    driver.press(Key::Space);
    EXPECT_TRUE(driver.sees("00:00.2")) << "the note's moment";
    trainee.tab_to("notes.reply");
    driver.type("Now I see it.");
    driver.press(Key::Enter);
    trainee.finish();
    EXPECT_TRUE(driver.sees("Now I see it."));
    EXPECT_THAT(driver.faults(), IsEmpty());
  }
  ASSERT_THAT(akin.course.trainee("ada").notes(akin.attempt).front().replies, SizeIs(1));
}

TEST(ReplayScreen, APlaceOnTheBoneIsOnItsSkin) {
  OperatedCourse akin;
  Watcher instructor(akin.course, "kim", akin.attempt);
  instructor.driver().press(Key::M);  // no mouse: what is in the middle
  instructor.driver().press(Key::C);
  instructor.driver().type("Here.");
  instructor.driver().press(Key::Enter, {.control = true});
  instructor.finish();
  const auto notes = akin.course.trainee("ada").notes(akin.attempt);
  ASSERT_THAT(notes, SizeIs(1));
  ASSERT_TRUE(notes.front().moment.place.has_value());
  const auto& place = notes.front().moment.place->point_in_bone_mm;
  const simulator::Bvh skin(akin.operation.bone.outer);
  EXPECT_NEAR(skin.signed_distance_mm(Vec3(place[0], place[1], place[2])), 0.0, 1.0e-5);
}

TEST(ReplayScreen, TheBladeViewShowsWhatLiesInItsPlane) {
  OperatedCourse akin;
  // In the middle of the first cut.
  Watcher watcher(akin.course, "ada", akin.attempt, 0.1);
  EXPECT_FALSE(watcher.driver().sees("to the far side"));
  watcher.driver().click("replay.views.4");
  watcher.finish();
  EXPECT_TRUE(watcher.driver().sees("to the far side"));
  EXPECT_THAT(watcher.driver().faults(), IsEmpty());
  watcher.driver().click("replay.views.1");
  EXPECT_FALSE(watcher.driver().sees("to the far side"));
}

TEST(ReplayScreen, APrivateNoteIsNeverSeenByTheTrainee) {
  OperatedCourse akin;
  Watcher instructor(akin.course, "kim", akin.attempt);
  instructor.driver().press(Key::C);
  instructor.driver().type("Ask about the left hand.");
  instructor.driver().click("pin.toggle");
  instructor.driver().click("pin.act");
  instructor.finish();
  EXPECT_TRUE(instructor.driver().sees("Ask about the left hand."));
  EXPECT_TRUE(instructor.driver().sees("Private"));
  instructor.driver().click("notes.note.1");
  EXPECT_FALSE(instructor.driver().has("notes.reply")) << "a private note has no answers";
  Watcher trainee(akin.course, "ada", akin.attempt);
  EXPECT_FALSE(trainee.driver().sees("Ask about the left hand."));
  EXPECT_TRUE(trainee.driver().sees("No notes yet"));
}

TEST(ReplayScreen, ATraineeFlagsTheMomentByKeyboard) {
  OperatedCourse akin;
  Watcher trainee(akin.course, "ada", akin.attempt, 0.3);
  trainee.driver().press(Key::F);
  trainee.driver().type("Where should I look?");
  trainee.driver().press(Key::Enter, {.control = true});
  trainee.finish();
  const auto requests = akin.course.trainee("ada").help_requests();
  ASSERT_THAT(requests, SizeIs(1));
  EXPECT_EQ(requests.front().moment.moment_us, 300'000);
  EXPECT_FALSE(trainee.driver().has("ask.act"));
  Watcher instructor(akin.course, "kim", akin.attempt);
  EXPECT_FALSE(instructor.driver().has("replay.flag")) << "an instructor answers, and asks nobody";
}

TEST(ReplayScreen, ARefusedNoteStaysInItsForm) {
  OperatedCourse akin;
  Watcher instructor(akin.course, "kim", akin.attempt);
  instructor.driver().click("replay.pin");
  instructor.driver().type("Look here.");
  akin.course.administrator().remove_from_cohort(akin.course.autumn(), "kim");
  instructor.driver().click("pin.act");
  instructor.finish();
  EXPECT_TRUE(instructor.driver().sees("not yours to write"));
  EXPECT_TRUE(instructor.driver().sees("Look here."));
  EXPECT_THAT(instructor.driver().faults(), IsEmpty());
}

TEST(ReplayScreen, TheTimelineIsScrubbed) {
  OperatedCourse akin;
  Watcher watcher(akin.course, "ada", akin.attempt);
  Driver& driver = watcher.driver();
  const Rect line = driver.widget("replay.timeline").rect;
  driver.drag({line.x + 200.0F, line.mid_y()}, {line.right() - 4.0F, line.mid_y()});
  EXPECT_FALSE(driver.sees("00:00.0"));
  driver.press(Key::Home);
  EXPECT_TRUE(driver.sees("00:00.0"));
}

TEST(ReplayScreen, AnAttemptThatCannotBeSeenSaysWhy) {
  OperatedCourse akin;
  Watcher other(akin.course, "bob", akin.attempt);
  EXPECT_TRUE(other.driver().sees("This could not be read"));
  EXPECT_FALSE(other.driver().sees("Akin"));
  Watcher unreadable(akin.course, "ada", akin.course.scored_by("ada", 50'000));
  EXPECT_TRUE(unreadable.driver().sees("This could not be read"));
  EXPECT_TRUE(unreadable.driver().has("replay.failed.action"));
}

TEST(ReplayScreen, NothingIsCutOffAtAnyScaleOrSize) {
  OperatedCourse akin;
  auto desk = akin.course.instructor("kim", akin.course.autumn());
  desk.add_note({akin.attempt,
                 {150'000, database::BonePoint{0, {6.0, 6.0, 0.0}}},
                 false,
                 "The blade touches before you have looked along it. Take one second here."});
  desk.add_note({akin.attempt, {400'000}, true, "Private words."});
  for (const float scale : {0.8F, 1.0F, 1.5F, 2.0F}) {
    Watcher watcher(akin.course, "kim", akin.attempt, 0.1, scale);
    for (const auto& [width, height] :
         {std::pair{1440.0F * scale, 900.0F * scale}, {1280.0F, 720.0F}, {3840.0F, 2160.0F}}) {
      watcher.driver().resize(width, height);
      watcher.driver().settle();
      for (const char* tab : {"replay.tab.1", "replay.tab.2", "replay.tab.0"}) {
        watcher.driver().click(tab);
        EXPECT_THAT(watcher.driver().faults(), IsEmpty()) << tab << " at " << scale;
      }
    }
  }
}

}  // namespace
}  // namespace hallux::ui
