#include "ui/screens/operating/flight/flight_screen.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "database/store/sql.h"
#include "tests/ui/screens/operating/some_operation.h"
#include "tests/ui/screens/some_visitor.h"

namespace hallux::ui {
namespace {

using testing::IsEmpty;

/// Ada in the first flight, over a screen to come back to.
struct Flier {
  explicit Flier(float scale = 1.0F, Point size = {1440.0F, 900.0F})
      : person(std::make_unique<FlightScreen>(signed_in, some_mouse), scale, size) {
    EXPECT_TRUE(person.until([&] { return driver().has("flight.skip"); }, 60.0));
  }

  Driver& driver() { return person.driver(); }
  bool is_in(const std::string& task) { return driver().sees(task); }
  void skip(int times) {
    for (int i = 0; i < times; ++i) person.press(Key::S);
  }
  /// Turns the view, as the first lesson asks.
  void look() {
    person.press(Key::Digit1);
    ASSERT_TRUE(person.until([&] { return is_in("ring on the block"); }));
  }

  database::SomeCourse course;
  /// Longer than the screen: the end of a session is stored.
  std::shared_ptr<SignedInSession> signed_in = visit_of(course, "ada");
  Operator person;
};

constexpr int lessons_in_all = static_cast<int>(lesson_count);

TEST(FlightScreen, BeginsWithALookAroundAndTheSawStandingStill) {
  Flier ada;
  EXPECT_TRUE(ada.driver().sees("First flight"));
  EXPECT_TRUE(ada.is_in("Turn the view"));
  EXPECT_TRUE(ada.driver().sees("Stopped"));
  EXPECT_FALSE(ada.driver().sees("Rec")) << "nothing is recorded";
  EXPECT_FALSE(ada.driver().has("operate.finish")) << "there is nothing to finish";
  ASSERT_TRUE(ada.person.until([&] { return ada.driver().sees("Keys: 1."); }));
}

TEST(FlightScreen, LessonsArePassedByTheirDeeds) {
  Flier ada;
  ada.look();
  EXPECT_TRUE(ada.driver().sees("from the ring. Now:"));
  ada.skip(1);
  EXPECT_TRUE(ada.is_in("while the teeth are still in air"));
  ada.person.press(Key::Space);
  EXPECT_TRUE(ada.person.until([&] { return ada.is_in("Push the blade down"); }));
}

TEST(FlightScreen, EachLessonIsSkippedByItsKeyAndTheEndSaysSo) {
  Flier ada;
  ada.look();
  ada.skip(lessons_in_all - 1);
  ASSERT_TRUE(ada.driver().sees("You have flown"));
  EXPECT_TRUE(ada.driver().sees("skipped"));
  EXPECT_FALSE(ada.driver().has("flight.skip"));
  EXPECT_THAT(ada.driver().faults(), IsEmpty());
  ada.person.press(Key::Enter);
  EXPECT_TRUE(ada.person.until([&] { return ada.person.is_gone(); }));
}

TEST(FlightScreen, EachLessonIsSkippedByItsButton) {
  Flier ada;
  for (int lesson = 0; lesson < lessons_in_all; ++lesson) {
    ASSERT_TRUE(ada.driver().has("flight.skip")) << lesson;
    ada.person.click("flight.skip");
  }
  EXPECT_TRUE(ada.driver().sees("You have flown"));
}

TEST(FlightScreen, WhoeverHasFlownCanFlyAgain) {
  Flier ada;
  ada.skip(lessons_in_all);
  ada.person.click("flight.fly_again");
  EXPECT_TRUE(ada.person.until([&] { return ada.driver().has("flight.skip"); }));
  EXPECT_TRUE(ada.is_in("Turn the view"));
}

TEST(FlightScreen, IsLeftAtAnyTimeWithoutAQuestion) {
  for (int lesson = 0; lesson < lessons_in_all; lesson += 3) {
    Flier ada;
    ada.skip(lesson);
    EXPECT_TRUE(ada.person.shell().top()->why_not_leave().empty());
    if (lesson == 3) {
      ada.person.click("operate.abandon");
    } else {
      ada.person.press(Key::End);
    }
    EXPECT_TRUE(ada.person.until([&] { return ada.person.is_gone(); })) << lesson;
  }
}

TEST(FlightScreen, ASpoiltBlockIsExchangedForAnUncutOne) {
  Flier ada;
  ada.look();
  ada.person.press(Key::R);
  ada.person.press(Key::Space);
  for (int press = 0; press < 6; ++press) ada.person.press(Key::PageUp);
  ASSERT_TRUE(ada.person.until([&] {
    ada.person.press(Key::PageUp);
    return ada.person.scenes.patch_triangles > 0;
  })) << "nothing was cut";
  ada.person.press(Key::B);
  ASSERT_TRUE(ada.person.until([&] { return ada.is_in("ring on the block"); }));
  EXPECT_TRUE(ada.person.until([&] { return ada.driver().sees("Stopped"); }));
  EXPECT_EQ(ada.person.scenes.patch_triangles, 0U);
}

TEST(FlightScreen, APauseIsACardAndP) {
  Flier ada;
  ada.person.press(Key::Escape);
  EXPECT_TRUE(ada.driver().sees("Paused"));
  EXPECT_THAT(ada.driver().faults(), IsEmpty());
  ada.person.press(Key::P);
  EXPECT_FALSE(ada.driver().sees("Paused"));
}

TEST(FlightScreen, APieceIsTakenOnlyOnceItIsFreeAndTheButtonSaysWhy) {
  Flier ada;
  ada.skip(lessons_in_all - 1);
  ASSERT_TRUE(ada.person.until([&] { return ada.driver().has("operate.step"); }));
  ASSERT_TRUE(ada.person.until([&] { return ada.driver().sees("the cut was not begun"); }));
  EXPECT_FALSE(ada.driver().widget("operate.step").is_enabled);
  EXPECT_THAT(ada.driver().off_without_reason(), IsEmpty());
}

/// A number that changes with each transaction of any other connection.
std::int64_t data_version(database::SomeCourse& course) {
  return database::single<std::int64_t>(course.database(), "PRAGMA data_version");
}

TEST(FlightScreen, NothingOfItIsStored) {
  Flier ada;
  const std::int64_t before = data_version(ada.course);
  ada.look();
  ada.person.press(Key::Space);
  ada.skip(lessons_in_all);
  ASSERT_TRUE(ada.driver().sees("You have flown"));
  ada.person.press(Key::Enter);
  ASSERT_TRUE(ada.person.until([&] { return ada.person.is_gone(); }));
  EXPECT_EQ(data_version(ada.course), before);
  EXPECT_THAT(database::list_attempts(ada.course.database()), IsEmpty());
}

TEST(FlightScreen, NothingIsCutOffInAnyLessonAtAnyScaleInBothThemes) {
  for (const float scale : {0.8F, 1.0F, 1.5F, 2.0F}) {
    Flier ada(scale, {1280.0F, 720.0F});
    const ThemeName theme = scale < 1.2F ? ThemeName::Dark : ThemeName::Light;
    ada.person.shell().preferences().theme = theme;
    for (int lesson = 0; lesson < lessons_in_all; ++lesson) {
      ada.person.make_frames(3);
      EXPECT_THAT(ada.driver().faults(), IsEmpty()) << scale << ", lesson " << lesson;
      ada.skip(1);
    }
    EXPECT_THAT(ada.driver().faults(), IsEmpty()) << scale << ", the end";
  }
}

}  // namespace
}  // namespace hallux::ui
