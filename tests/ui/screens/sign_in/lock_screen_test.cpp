#include "ui/screens/sign_in/lock_screen.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/ui/screens/every_size.h"
#include "ui/screens/sign_in/account_screen.h"

namespace hallux::ui {
namespace {

using database::cheap;
using database::good_password;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

/// A screen that may be kept from being left, as one that records.
class KeptScreen : public Screen {
 public:
  explicit KeptScreen(const std::string& reason) : reason_(reason) {}
  GuideSection guide_section() const override { return GuideSection::Overview; }
  std::string_view why_not_leave() const override { return reason_; }
  void draw(Ui& ui, const Rect& content, Shell& /*shell*/) override {
    ui.canvas().text_in(content, {Type::Body, ui.theme().text}, "what lies open");
  }

 private:
  const std::string& reason_;
};

struct LockedStation {
  explicit LockedStation(database::SomeCourse& course, std::string recorded = "")
      : reason(std::move(recorded)),
        signed_in(visit_of(course, "ada")),
        visitor(std::make_unique<KeptScreen>(reason)) {
    visitor.shell().lock(std::make_unique<LockScreen>(
        signed_in, [this] { is_signed_out = true; }, cheap));
    visitor.driver().frame();
    visitor.driver().settle();
  }
  void try_with(const char* password) {
    visitor.driver().click("lock.password");
    visitor.driver().type(password);
    visitor.driver().press(Key::Enter);
    visitor.finish_work();
  }

  std::string reason;
  bool is_signed_out = false;
  std::shared_ptr<SignedInSession> signed_in;
  SomeVisitor visitor;
};

TEST(LockScreen, HidesWhatLiesOpenUntilTheSamePersonsPasswordComes) {
  database::SomeCourse course;
  LockedStation station(course);
  EXPECT_TRUE(station.visitor.driver().sees("ada is signed in"));
  EXPECT_FALSE(station.visitor.driver().sees("what lies open"));
  station.try_with("not the password");
  EXPECT_TRUE(station.visitor.shell().is_locked());
  EXPECT_THAT(all_text(station.visitor.driver()), HasSubstr("The password is wrong"));
  station.try_with(good_password);
  EXPECT_FALSE(station.visitor.shell().is_locked());
  EXPECT_TRUE(station.visitor.driver().sees("what lies open"));
}

TEST(LockScreen, CountsDownAfterWrongPasswords) {
  database::SomeCourse course;
  LockedStation station(course);
  station.try_with("not the password");
  // As after six: a slow machine must not let the wait pass by.
  database::tamper(course.database(), "UPDATE sign_in_guard SET failures = 6");
  station.try_with(good_password);
  Driver& driver = station.visitor.driver();
  EXPECT_TRUE(station.visitor.shell().is_locked());
  EXPECT_THAT(all_text(driver), HasSubstr("You can try again in"));
  driver.click("lock.password");
  driver.type(good_password);
  EXPECT_FALSE(driver.widget("lock.open").is_enabled);
  driver.wait(8.5);
  EXPECT_TRUE(driver.widget("lock.open").is_enabled);
  EXPECT_THAT(all_text(driver), Not(HasSubstr("try again in")));
}

TEST(LockScreen, LetsSomebodyElseSignInWhereNothingIsRecorded) {
  database::SomeCourse course;
  LockedStation station(course);
  station.visitor.driver().click("lock.other");
  EXPECT_TRUE(station.is_signed_out);
}

TEST(LockScreen, KeepsARecordingForWhoBeganIt) {
  database::SomeCourse course;
  LockedStation station(course, "The attempt is still being recorded.");
  EXPECT_FALSE(station.visitor.driver().has("lock.other"));
  EXPECT_THAT(all_text(station.visitor.driver()), HasSubstr("only ada can go on"));
  for (const Key key : {Key::Escape, Key::F1}) station.visitor.driver().press(key);
  EXPECT_TRUE(station.visitor.shell().is_locked());
  station.try_with(good_password);
  EXPECT_TRUE(station.visitor.driver().sees("what lies open"));
}

TEST(LockScreen, EndsTheSessionAfterTwelveHours) {
  database::SomeCourse course;
  LockedStation station(course, "The attempt is still being recorded.");
  station.visitor.driver().frame(11.9 * 3600.0);
  EXPECT_FALSE(station.is_signed_out);
  station.visitor.driver().frame(0.2 * 3600.0);
  EXPECT_TRUE(station.is_signed_out);
}

TEST(LockScreen, NothingIsCutOffAtAnySize) {
  database::SomeCourse course;
  const auto make = [&] {
    return std::make_unique<LockScreen>(
        visit_of(course, "ada"), [] {}, cheap);
  };
  EXPECT_THAT(faults_at_every_size(make), IsEmpty());
}

}  // namespace
}  // namespace hallux::ui
