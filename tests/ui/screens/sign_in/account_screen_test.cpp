#include "ui/screens/sign_in/account_screen.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "database/people/people.h"
#include "tests/ui/screens/every_size.h"

namespace hallux::ui {
namespace {

using database::cheap;
using database::good_password;
using database::SecretText;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

constexpr const char* another_password = "quite another long phrase";

/// Somebody in front of their account.
struct AtAccount {
  explicit AtAccount(database::SomeCourse& of, const std::string& login = "lee")
      : course(of), visitor(std::make_unique<AccountScreen>(visit_of(of, login), cheap)) {}
  Driver& driver() { return visitor.driver(); }
  /// Opens the dialog and writes all three by keyboard alone.
  void write(const char* old_password, const char* new_password, const char* again) {
    driver().click("account.change_password");
    driver().type(old_password);
    for (const char* words : {new_password, again}) {
      driver().press(Key::Tab);
      if (driver().focused().ends_with(".eye")) driver().press(Key::Tab);
      driver().type(words);
    }
  }
  void send() {
    driver().press(Key::Enter);
    visitor.finish_work();
  }
  bool knows(const std::string& login, const char* password) {
    std::string words = password;
    return database::verify_person(course.database(), login, SecretText::take(words), cheap)
        .has_value();
  }

  database::SomeCourse& course;
  SomeVisitor visitor;
};

TEST(AccountScreen, SaysWhoOneIsAndInWhichCohorts) {
  database::SomeCourse course;
  AtAccount at(course);
  for (const char* words : {"Your account", "lee", "autumn", "spring", "Trainee", "Instructor"})
    EXPECT_TRUE(at.driver().sees(words)) << words;
  AtAccount administrator(course, "root");
  EXPECT_TRUE(administrator.driver().sees("Administrator"));
  EXPECT_TRUE(administrator.driver().sees("You are in no cohort"));
}

TEST(AccountScreen, ANewPasswordWorksAndTheOldOneNoLonger) {
  database::SomeCourse course;
  AtAccount at(course);
  at.write(good_password, another_password, another_password);
  at.send();
  EXPECT_THAT(all_text(at.driver()), HasSubstr("Your password was changed"));
  EXPECT_FALSE(at.driver().has("account.password.act"));
  EXPECT_TRUE(at.knows("lee", another_password));
  EXPECT_FALSE(at.knows("lee", good_password));
}

TEST(AccountScreen, AWrongOldPasswordIsSaidAndChangesNothing) {
  database::SomeCourse course;
  AtAccount at(course);
  at.write("not the right phrase", another_password, another_password);
  at.send();
  EXPECT_THAT(all_text(at.driver()), HasSubstr("old password is wrong"));
  EXPECT_TRUE(at.driver().has("account.password.act")) << "what was typed stays";
  EXPECT_TRUE(at.knows("lee", good_password));
}

TEST(AccountScreen, AWeakPasswordIsSaidAndChangesNothing) {
  database::SomeCourse course;
  AtAccount at(course);
  at.write(good_password, "short", "short");
  at.send();
  EXPECT_TRUE(at.driver().sees("12"));
  EXPECT_TRUE(at.knows("lee", good_password));
}

TEST(AccountScreen, PasswordsThatDifferCannotBeSent) {
  database::SomeCourse course;
  AtAccount at(course);
  at.write(good_password, another_password, "quite another long phrasE");
  EXPECT_THAT(all_text(at.driver()), HasSubstr("The two passwords differ"));
  EXPECT_FALSE(at.driver().widget("account.password.act").is_enabled);
}

TEST(AccountScreen, NoPasswordIsEverAmongTheTextsOfAFrame) {
  database::SomeCourse course;
  AtAccount at(course);
  at.write(good_password, another_password, another_password);
  for (const std::string& text : at.driver().texts()) {
    EXPECT_THAT(text, Not(HasSubstr(good_password)));
    EXPECT_THAT(text, Not(HasSubstr(another_password)));
  }
}

TEST(AccountScreen, AnAdministratorSaysWhenWindowsLock) {
  database::SomeCourse course;
  AtAccount trainee(course, "ada");
  EXPECT_TRUE(trainee.driver().sees("10 min"));
  EXPECT_FALSE(trainee.driver().has("account.lock.2"));
  AtAccount administrator(course, "root");
  administrator.driver().click("account.lock.2");
  administrator.visitor.finish_work();
  EXPECT_THAT(all_text(administrator.driver()), HasSubstr("Windows lock after 20 minutes"));
  EXPECT_EQ(visit_of(course, "ada")->idle_lock_s(), 20.0 * 60.0);
}

TEST(AccountScreen, NothingIsCutOffAtAnySize) {
  database::SomeCourse course;
  const auto make = [&] { return std::make_unique<AccountScreen>(visit_of(course, "lee"), cheap); };
  EXPECT_THAT(faults_at_every_size(make), IsEmpty());
  EXPECT_THAT(faults_at_every_size(
                  [&] { return std::make_unique<AccountScreen>(visit_of(course, "root"), cheap); }),
              IsEmpty());
  EXPECT_THAT(
      faults_at_every_size(
          make, [](SomeVisitor& visitor) { visitor.driver().click("account.change_password"); }),
      IsEmpty());
}

TEST(AccountScreen, ExportsWhatIsKeptOfOneselfIntoANewFolder) {
  database::SomeCourse course;
  AtAccount at(course);
  const std::filesystem::path folder = course.database().directory().parent_path() / "of-lee";
  at.driver().click("account.export");
  EXPECT_FALSE(at.driver().widget("account.export.act").is_enabled) << "a folder has no name yet";
  at.driver().press(Key::A, {.control = true});
  at.driver().type(folder.string());
  at.send();
  EXPECT_THAT(all_text(at.driver()), HasSubstr("It was exported"));
  EXPECT_TRUE(std::filesystem::exists(folder / "explanation.txt"));
  EXPECT_EQ(course.last_audit().action, "person_exported");
}

TEST(AccountScreen, AnExportIntoAFolderThatHoldsSomethingIsRefusedAndSaid) {
  database::SomeCourse course;
  AtAccount at(course);
  at.driver().click("account.export");
  at.driver().press(Key::A, {.control = true});
  at.driver().type(course.database().directory().parent_path().string());
  at.send();
  EXPECT_THAT(all_text(at.driver()), HasSubstr("holds something already"));
  EXPECT_TRUE(at.driver().has("account.export.act")) << "what was typed stays";
}

TEST(AccountScreen, TheHandOnTheSawIsChosenThereByMouseAndByKeys) {
  database::SomeCourse course;
  AtAccount at(course);
  const HandPreferences& hand = at.visitor.shell().hand();
  ASSERT_FALSE(hand.is_left_handed);
  at.driver().click("account.hand.1");
  EXPECT_TRUE(hand.is_left_handed);
  at.driver().press(Key::Left);
  EXPECT_EQ(at.driver().focused(), "account.hand.0");
  at.driver().press(Key::Space);
  EXPECT_FALSE(hand.is_left_handed);
}

}  // namespace
}  // namespace hallux::ui
