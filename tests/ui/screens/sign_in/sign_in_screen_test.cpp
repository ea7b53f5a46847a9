#include "ui/screens/sign_in/sign_in_screen.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "database/people/people.h"
#include "tests/database/some_course.h"
#include "tests/support/own_memory.h"
#include "tests/ui/screens/some_visitor.h"
#include "ui/widgets/texts/wipe.h"

namespace hallux::ui {
namespace {

using database::cheap;
using database::good_password;
using testing::IsEmpty;

/// A person in front of the first screen of a data directory.
struct Arrival {
  explicit Arrival(const std::filesystem::path& directory, float scale = 1.0F)
      : visitor(std::make_unique<SignInScreen>(
                    directory,
                    [this](Shell&, std::shared_ptr<SignedInSession> entered) {
                      signed_in = std::move(entered);
                    },
                    cheap),
                scale) {}

  Driver& driver() { return visitor.driver(); }
  void fill(std::string_view field, std::string_view words) {
    driver().click(field);
    driver().type(words);
  }
  void press(std::string_view id) {
    driver().click(id);
    visitor.finish_work();
  }

  std::shared_ptr<SignedInSession> signed_in;
  SomeVisitor visitor;
};

TEST(SignInScreen, TheFirstPersonBecomesTheAdministrator) {
  const database::TemporaryDirectory temporary;
  Arrival arrival(temporary.data());
  EXPECT_TRUE(arrival.driver().sees("Begin a course"));
  EXPECT_FALSE(arrival.driver().widget("entry.begin").is_enabled);
  arrival.fill("entry.login", "admin-1");
  arrival.fill("entry.name", "Administrator");
  arrival.fill("entry.password", good_password);
  arrival.fill("entry.password_again", good_password);
  arrival.press("entry.begin");
  ASSERT_NE(arrival.signed_in, nullptr);
  EXPECT_EQ(arrival.signed_in->person().login, "admin-1");
  EXPECT_TRUE(arrival.signed_in->person().is_administrator);
}

TEST(SignInScreen, PasswordsThatDifferMakeNobody) {
  const database::TemporaryDirectory temporary;
  Arrival arrival(temporary.data());
  arrival.fill("entry.login", "admin-1");
  arrival.fill("entry.password", good_password);
  arrival.fill("entry.password_again", "a long enough phrasE");
  arrival.press("entry.begin");
  EXPECT_TRUE(arrival.driver().sees("The two passwords differ"));
  EXPECT_EQ(arrival.signed_in, nullptr);
  EXPECT_TRUE(is_without_people(temporary.data()));
}

TEST(SignInScreen, AWeakPasswordIsSaidAndMakesNobody) {
  const database::TemporaryDirectory temporary;
  Arrival arrival(temporary.data());
  arrival.fill("entry.login", "admin-1");
  arrival.fill("entry.password", "short");
  arrival.fill("entry.password_again", "short");
  arrival.press("entry.begin");
  EXPECT_TRUE(arrival.driver().sees("12"));
  EXPECT_EQ(arrival.signed_in, nullptr);
  EXPECT_TRUE(is_without_people(temporary.data()));
}

TEST(SignInScreen, SaysByKeyboardWhatIsMissing) {
  database::SomeCourse course;
  Arrival arrival(course.database().directory());
  expect_reason_by_keyboard(arrival.driver(), "entry.sign_in");
  EXPECT_EQ(arrival.signed_in, nullptr);
}

TEST(SignInScreen, SignsInByKeyboardAlone) {
  database::SomeCourse course;
  Arrival arrival(course.database().directory());
  EXPECT_EQ(arrival.driver().focused(), "entry.login");
  arrival.driver().type("ada");
  arrival.driver().press(Key::Tab);
  arrival.driver().type(good_password);
  arrival.driver().press(Key::Enter);
  arrival.visitor.finish_work();
  ASSERT_NE(arrival.signed_in, nullptr);
  EXPECT_EQ(arrival.signed_in->person().login, "ada");
}

TEST(SignInScreen, AWrongPasswordIsSaidLikeAnUnknownLogin) {
  database::SomeCourse course;
  std::vector<std::string> seen;
  for (const std::string login : {"ada", "eva"}) {  // nobody is called eva
    Arrival arrival(course.database().directory());
    arrival.fill("entry.login", login);
    arrival.fill("entry.password", "not the right phrase");
    arrival.press("entry.sign_in");
    EXPECT_EQ(arrival.signed_in, nullptr);
    EXPECT_FALSE(arrival.driver().widget("entry.sign_in").is_enabled) << "the password stayed";
    std::string& all = seen.emplace_back();
    for (const std::string& text : arrival.driver().texts()) all += text + "\n";
    for (std::size_t at = all.find(login); at != std::string::npos; at = all.find(login, at)) {
      all.replace(at, login.size(), "LOGIN");
    }
  }
  EXPECT_EQ(seen[0], seen[1]);
}

TEST(SignInScreen, CountsDownAfterWrongPasswords) {
  database::SomeCourse course;
  Arrival arrival(course.database().directory());
  arrival.fill("entry.login", "ada");
  arrival.fill("entry.password", "not the right phrase");
  arrival.press("entry.sign_in");
  // As after six: a slow machine must not let the wait pass by.
  database::tamper(course.database(), "UPDATE sign_in_guard SET failures = 6");
  arrival.fill("entry.password", good_password);
  arrival.press("entry.sign_in");
  EXPECT_EQ(arrival.signed_in, nullptr);
  EXPECT_TRUE(arrival.driver().sees("You can try again in"));
  arrival.fill("entry.password", good_password);
  EXPECT_FALSE(arrival.driver().widget("entry.sign_in").is_enabled);
  arrival.driver().wait(8.5);
  EXPECT_TRUE(arrival.driver().widget("entry.sign_in").is_enabled);
}

TEST(SignInScreen, LetsSomebodyElseSignInWhileOneWaits) {
  database::SomeCourse course;
  Arrival arrival(course.database().directory());
  arrival.fill("entry.login", "ada");
  arrival.fill("entry.password", "not the right phrase");
  arrival.press("entry.sign_in");
  database::tamper(course.database(), "UPDATE sign_in_guard SET failures = 9");
  arrival.fill("entry.password", "not the right phrase");
  arrival.press("entry.sign_in");
  EXPECT_TRUE(arrival.driver().sees("You can try again in"));
  arrival.driver().click("entry.login");
  arrival.driver().press(Key::A, {.control = true});
  arrival.driver().type("bob");
  arrival.fill("entry.password", good_password);
  arrival.press("entry.sign_in");
  ASSERT_NE(arrival.signed_in, nullptr);
  EXPECT_EQ(arrival.signed_in->person().login, "bob");
}

TEST(SignInScreen, LeavesNoPasswordInMemory) {
  database::SomeCourse course;
  const PlantedSecret planted;
  std::string spelled = planted.spelled();
  const auto taken = [&] {
    std::string copy = planted.spelled();
    return database::SecretText::take(copy);
  };
  course.administrator().set_password("ada", taken(), cheap);
  Arrival arrival(course.database().directory());
  arrival.fill("entry.login", "ada");
  arrival.fill("entry.password", spelled);
  wipe(spelled);
  arrival.press("entry.sign_in");
  ASSERT_NE(arrival.signed_in, nullptr);
  EXPECT_EQ(planted.places_in_memory(), 0U);
}

TEST(SignInScreen, AOneTimeCodeChoosesAPassword) {
  database::SomeCourse course;
  const auto added = course.administrator().add_person_with_code({"trainee-9", "", false}, cheap);
  Arrival arrival(course.database().directory());
  arrival.driver().click("entry.to_code");
  arrival.fill("entry.login", "trainee-9");
  arrival.fill("entry.code", added.issued.code.view());
  arrival.fill("entry.password", good_password);
  arrival.fill("entry.password_again", good_password);
  arrival.press("entry.redeem");
  ASSERT_NE(arrival.signed_in, nullptr);
  EXPECT_EQ(arrival.signed_in->person().login, "trainee-9");
}

TEST(SignInScreen, ACodeWrittenAsThePasswordIsToldAndCountsAsNoRefusal) {
  database::SomeCourse course;
  const auto added = course.administrator().add_person_with_code({"trainee-9", "", false}, cheap);
  const std::int64_t acts = course.administrator().audit_page({}).total;
  Arrival arrival(course.database().directory());
  arrival.fill("entry.login", "trainee-9");
  arrival.fill("entry.password", added.issued.code.view());
  arrival.press("entry.sign_in");
  EXPECT_TRUE(arrival.driver().sees("looks like a one-time code"));
  EXPECT_EQ(course.administrator().audit_page({}).total, acts + 1) << "of the administrator alone";
  arrival.press("entry.to_code");
  arrival.fill("entry.password", good_password);
  arrival.fill("entry.password_again", good_password);
  arrival.press("entry.redeem");
  ASSERT_NE(arrival.signed_in, nullptr) << "the code went along";
  EXPECT_TRUE(arrival.signed_in->notices().empty());
}

TEST(SignInScreen, APasswordThatLooksLikeACodeIsSentAtTheSecondPress) {
  database::SomeCourse course;
  course.administrator().set_password("ada", database::secret("k7m2-qwer-90zx"), cheap);
  Arrival arrival(course.database().directory());
  arrival.fill("entry.login", "ada");
  arrival.fill("entry.password", "k7m2-qwer-90zx");
  arrival.press("entry.sign_in");
  EXPECT_EQ(arrival.signed_in, nullptr);
  arrival.press("entry.sign_in");
  EXPECT_NE(arrival.signed_in, nullptr);
}

TEST(SignInScreen, ALoginThatIsNotAllowedIsToldAtTheFieldAndWipesNothing) {
  const database::TemporaryDirectory temporary;
  Arrival arrival(temporary.data());
  arrival.fill("entry.login", "Admin");
  EXPECT_TRUE(arrival.driver().sees("with a letter first"));
  arrival.fill("entry.password", good_password);
  arrival.fill("entry.password_again", "another long phrase");
  EXPECT_FALSE(arrival.driver().widget("entry.begin").is_enabled);
  arrival.driver().click("entry.login");
  arrival.driver().press(Key::A, {.control = true});
  arrival.driver().type("admin-1");
  EXPECT_FALSE(arrival.driver().sees("with a letter first"));
  arrival.press("entry.begin");
  EXPECT_TRUE(arrival.driver().sees("differ"));
  arrival.driver().click("entry.password_again");
  arrival.driver().press(Key::A, {.control = true});
  arrival.driver().type(good_password);
  arrival.press("entry.begin");
  EXPECT_NE(arrival.signed_in, nullptr) << "the first password was still there";
}

TEST(SignInScreen, WhatIsRefusedStaysInTheFieldsOfANewPassword) {
  const database::TemporaryDirectory temporary;
  Arrival arrival(temporary.data());
  arrival.fill("entry.login", "admin-1");
  arrival.fill("entry.password", "short");
  arrival.fill("entry.password_again", "short");
  arrival.press("entry.begin");
  EXPECT_EQ(arrival.signed_in, nullptr);
  for (const char* field : {"entry.password", "entry.password_again"}) {
    arrival.driver().click(field);
    arrival.driver().press(Key::End);
    arrival.driver().type(" becomes a phrase");
  }
  arrival.press("entry.begin");
  EXPECT_NE(arrival.signed_in, nullptr);
}

TEST(SignInScreen, ACourseThatCannotBeOpenedSaysWhyAndTriesAgain) {
  const database::TemporaryDirectory temporary;
  std::ofstream(temporary.data()) << "a file stands where the folder should be";
  Arrival arrival(temporary.data());
  EXPECT_TRUE(arrival.driver().sees("The course cannot be opened"));
  std::filesystem::remove(temporary.data());
  arrival.press("entry.unusable.action");
  EXPECT_TRUE(arrival.driver().sees("Begin a course"));
}

TEST(SignInScreen, NothingIsCutOffAtAnyScale) {
  database::SomeCourse course;
  const database::TemporaryDirectory temporary;
  for (const float scale : {0.8F, 1.0F, 1.5F, 2.0F}) {
    Arrival first(temporary.data(), scale);
    EXPECT_THAT(first.driver().faults(), IsEmpty()) << scale;
    Arrival known(course.database().directory(), scale);
    EXPECT_THAT(known.driver().faults(), IsEmpty()) << scale;
    known.driver().click("entry.to_code");
    EXPECT_THAT(known.driver().faults(), IsEmpty()) << scale;
  }
}

}  // namespace
}  // namespace hallux::ui
