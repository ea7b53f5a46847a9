#include "ui/app/window/course.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/database/some_course.h"
#include "tests/ui/app/window/course_window.h"

namespace hallux::ui {
namespace {

using database::cheap;
using database::good_password;

/// The course's window with somebody in front of it.
struct AtWindow {
  explicit AtWindow(database::SomeCourse& course)
      : window(course.database().directory(), cheap, [](Shell& shell, Ui& ui) { shell.draw(ui); }) {
  }
  void sign_in(const std::string& login) { window.sign_in(login, good_password); }
  Driver& driver() { return window.driver(); }
  void lock() {
    driver().frame(10.0 * 60.0 + 1.0);
    driver().settle();
  }

  CourseWindow window;
};

/// All texts behind each other: a sentence may be broken into lines.
std::string words_in(const Driver& driver) {
  std::string all;
  for (const std::string& text : driver.texts()) all += text + " ";
  return all;
}

/// The messages' ways on, by id.
std::vector<std::string> actions_in(const Driver& driver) {
  std::vector<std::string> ids;
  for (const Widget& widget : driver.content().widgets) {
    if (widget.id.starts_with("message.") && widget.id.ends_with(".action")) {
      ids.push_back(widget.id);
    }
  }
  return ids;
}

TEST(Course, HowSomebodyHoldsTheSawComesAndGoesWithThem) {
  database::SomeCourse course;
  AtWindow first(course);
  first.sign_in("ada");
  EXPECT_EQ(first.window.shell().hand(), HandPreferences{});
  first.window.shell().hand() = {true, 1.5, 0.25};
  first.driver().frame();
  first.window.finish_work();
  first.window.shell().set_hand({});
  AtWindow second(course);
  second.sign_in("bob");
  EXPECT_EQ(second.window.shell().hand(), HandPreferences{});
  AtWindow third(course);
  third.sign_in("ada");
  EXPECT_EQ(third.window.shell().hand(), (HandPreferences{true, 1.5, 0.25}));
}

TEST(Course, TellsWhatHappenedMeanwhileUntilItWasSeen) {
  database::SomeCourse course;
  course.administrator().set_password("ada", database::secret(good_password), cheap);
  AtWindow first(course);
  first.sign_in("ada");
  EXPECT_THAT(words_in(first.driver()), testing::HasSubstr("root set your password"));
  AtWindow second(course);
  second.sign_in("ada");
  ASSERT_EQ(actions_in(second.driver()).size(), 1U);
  second.driver().click(actions_in(second.driver()).front());
  second.window.finish_work();
  AtWindow third(course);
  third.sign_in("ada");
  EXPECT_TRUE(actions_in(third.driver()).empty());
}

TEST(Course, NamesWhoOverrodeAResultAndCountsTheAttemptAlikeForBoth) {
  database::SomeCourse course("Bob Wire");
  course.scored_by("bob", 40'000);
  course.recorded_by_robot();
  course.scored_by("eve", 50'000);
  const database::AttemptId second = course.scored_by("bob", 60'000);
  course.instructor("kim", course.autumn())
      .decide({second, database::DecisionKind::Overridden, 70'000, "the station slipped"});
  AtWindow trainee(course);
  trainee.sign_in("bob");
  EXPECT_THAT(words_in(trainee.driver()), testing::HasSubstr("kim overrode"));
  trainee.driver().click("nav.history");
  trainee.window.finish_work();
  AtWindow instructor(course);
  instructor.sign_in("kim");
  instructor.driver().click("nav.attempts");
  instructor.window.finish_work();
  const std::string newest = std::to_string(course.trainee("bob").header(second).order);
  trainee.driver().click("history.list." + newest);
  instructor.driver().click("attempts." + newest);
  for (AtWindow* at : {&trainee, &instructor}) {
    at->window.finish_work();
    EXPECT_TRUE(at->driver().sees("Attempt 2"));
    EXPECT_THAT(words_in(at->driver()), testing::HasSubstr("kim set this score"));
  }
}

TEST(Course, LocksWhenNobodyTouchesItAndOpensWhereItWas) {
  database::SomeCourse course;
  AtWindow at(course);
  at.sign_in("root");
  at.driver().click("nav.records");
  at.window.finish_work();
  at.lock();
  EXPECT_TRUE(at.driver().sees("Locked"));
  EXPECT_FALSE(at.driver().has("nav.records"));
  at.driver().press(Key::Digit1, {.control = true});
  EXPECT_TRUE(at.driver().sees("Locked"));
  at.driver().type(good_password);
  at.driver().press(Key::Enter);
  at.window.finish_work();
  EXPECT_FALSE(at.window.shell().is_locked());
  EXPECT_EQ(at.window.shell().top()->navigation_id(), "nav.records");
}

TEST(Course, LetsSomebodyElseInAtALockedWindow) {
  database::SomeCourse course;
  AtWindow at(course);
  at.sign_in("ada");
  at.lock();
  at.driver().click("lock.other");
  at.window.finish_work();
  EXPECT_TRUE(at.driver().has("entry.login"));
  at.sign_in("bob");
  EXPECT_FALSE(at.window.shell().is_locked());
  EXPECT_EQ(at.window.shell().visitor()->name, "bob");
}

TEST(Course, EndsTheSessionWithItsWindow) {
  database::SomeCourse course;
  {
    AtWindow at(course);
    at.sign_in("ada");
    EXPECT_EQ(course.last_audit().action, "signed_in");
  }
  EXPECT_EQ(course.last_audit().action, "signed_out");
}

}  // namespace
}  // namespace hallux::ui
