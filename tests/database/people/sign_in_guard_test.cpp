#include "database/people/sign_in_guard.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdio>

#include "tests/database/some_course.h"

namespace hallux::database {

namespace {

/// The course at a time that tests set, in seconds from a morning on.
class GuardedCourse : public testing::Test, protected SomeCourse {
 protected:
  GuardedCourse() { it_is_s(0); }

  void it_is_s(int second) {
    std::array<char, 40> text{};
    std::snprintf(text.data(), text.size(), "2026-03-%02dT%02d:%02d:%02d.000Z", 10 + second / 86400,
                  second / 3600 % 24, second / 60 % 60, second % 60);
    database().pretend_it_is(text.data());
    now_s_ = second;
  }
  void wait_s(int seconds) { it_is_s(now_s_ + seconds); }

  /// How long one has to wait; 0 where the password was looked at.
  int refused(const std::string& login) {
    try {
      sign_in(database(), login, secret("not the password"), cheap);
    } catch (const TooSoon& soon) {
      EXPECT_EQ(soon.kind(), DatabaseErrorKind::Refused);
      return soon.wait_s();
    } catch (const DatabaseError& error) {
      EXPECT_EQ(error.kind(), DatabaseErrorKind::Refused);
      return 0;
    }
    ADD_FAILURE() << "a wrong password was taken";
    return 0;
  }

  void refuse_times(const std::string& login, int times) {
    for (int i = 0; i < times; ++i) {
      while (const int seconds = refused(login)) wait_s(seconds);
    }
  }

  std::int64_t rows() {
    SQLite::Statement row{database().connection(), "SELECT count(*) FROM sign_in_guard"};
    row.executeStep();
    return row.getColumn(0).getInt64();
  }

 private:
  int now_s_ = 0;
};

TEST(SignInGuard, DoublesTheWaitUpToAMinute) {
  constexpr std::array<int, 12> expected{0, 0, 0, 1, 2, 4, 8, 16, 32, 60, 60, 60};
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(wait_of_pair_s(static_cast<std::int64_t>(i)), expected[i]) << i;
  }
  EXPECT_EQ(wait_of_pair_s(1'000'000), 60);
  EXPECT_EQ(wait_of_others_s(9), 0);
  EXPECT_EQ(wait_of_others_s(10), 1);
  EXPECT_EQ(wait_of_others_s(1'000'000), 8);
}

TEST_F(GuardedCourse, GivesThreeTriesAndThenMakesOneWait) {
  for (int i = 0; i < 3; ++i) EXPECT_EQ(refused("ada"), 0);
  EXPECT_EQ(refused("ada"), 1);
  // Who comes too soon is not looked at: the right password neither, and it does not count.
  EXPECT_THROW(sign_in_as("ada"), TooSoon);
  wait_s(1);
  EXPECT_EQ(refused("ada"), 0);
  EXPECT_EQ(refused("ada"), 2);
  wait_s(2);
  EXPECT_NO_THROW(sign_in_as("ada"));
  EXPECT_EQ(refused("ada"), 0);
}

TEST_F(GuardedCourse, SaysTheSameOfSomebodyWhoIsNotKnown) {
  const auto sentence = [&](const std::string& login) {
    refuse_times(login, 5);
    try {
      sign_in(database(), login, secret("not the password"), cheap);
    } catch (const TooSoon& soon) {
      std::string text = soon.what();
      return text.replace(text.find(login), login.size(), "?");
    }
    return std::string{};
  };
  const std::string known = sentence("ada");
  EXPECT_NE(known.find("seconds"), std::string::npos);
  it_is_s(4 * 3600);
  EXPECT_EQ(sentence("zoe"), known);
}

TEST_F(GuardedCourse, AllowsFewerThanAHundredTriesAnHour) {
  int looked_at = 0;
  for (int second = 0; second < 3600; ++second) {
    it_is_s(second);
    while (refused("ada") == 0) ++looked_at;
  }
  EXPECT_LT(looked_at, 75);
  EXPECT_GT(looked_at, 50);
}

TEST_F(GuardedCourse, KeepsNobodyOutForLongFromAnotherStation) {
  database().pretend_to_be("the station of somebody else");
  refuse_times("ada", 30);
  EXPECT_EQ(refused("ada"), 60);
  database().pretend_to_be("ada's station");
  const int wait = refused("ada");
  EXPECT_GT(wait, 0);
  EXPECT_LE(wait, 8);
  wait_s(wait);
  EXPECT_NO_THROW(sign_in_as("ada"));
}

TEST_F(GuardedCourse, SlowsOnePasswordTriedOnManyPeople) {
  for (int i = 0; i < 10; ++i) EXPECT_EQ(refused("person-" + std::to_string(i)), 0);
  EXPECT_EQ(refused("person-10"), 1);
  EXPECT_EQ(refused("ada"), 1);
  refuse_times("ada", 3);
  database().pretend_to_be("another station");
  EXPECT_NO_THROW(sign_in_as("bob"));
}

TEST_F(GuardedCourse, RemembersAfterARestart) {
  for (int i = 0; i < 4; ++i) refused("ada");
  Database again = database().open_again();
  EXPECT_THROW(sign_in(again, "ada", secret(good_password), cheap), TooSoon);
}

TEST_F(GuardedCourse, CountsTriesThatBeganAtOnce) {
  // As four processes do that all ask before the first has an answer.
  for (int i = 0; i < 3; ++i) EXPECT_NO_THROW(count_try(database(), "ada"));
  EXPECT_THROW(count_try(database(), "ada"), TooSoon);
}

TEST_F(GuardedCourse, WaitsNoLongerWhereTheClockWasSetBack) {
  it_is_s(20 * 86400);
  refuse_times("ada", 5);
  it_is_s(0);
  const int wait = refused("ada");
  EXPECT_LE(wait, 4);
  wait_s(wait);
  EXPECT_NO_THROW(sign_in_as("ada"));
}

TEST_F(GuardedCourse, ForgetsWhatIsADayOld) {
  refuse_times("zoe", 8);
  EXPECT_EQ(rows(), 1);
  wait_s(2 * 86400);
  EXPECT_NO_THROW(sign_in_as("ada"));
  EXPECT_EQ(rows(), 0);
}

TEST_F(GuardedCourse, GuardsCodesAndPasswordsThatAreAskedAgain) {
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(kind_thrown([&] {
                redeem_code(database(), "ada", secret("7QK2-M9XD-3VTA"), secret(good_password),
                            cheap);
              }),
              DatabaseErrorKind::Refused);
  }
  EXPECT_THROW(
      redeem_code(database(), "ada", secret("7QK2-M9XD-3VTA"), secret(good_password), cheap),
      TooSoon);
  Session bob = sign_in_as("bob");
  for (int i = 0; i < 2; ++i) {
    EXPECT_EQ(kind_thrown([&] { bob.prove(secret("not the password"), cheap); }),
              DatabaseErrorKind::Refused);
  }
  EXPECT_EQ(last_audit().action, "password_asked");
  EXPECT_TRUE(last_audit().was_refused);
  EXPECT_EQ(bob.prove(secret(good_password), cheap).person(), id_of("bob"));
  for (int i = 0; i < 3; ++i) {
    EXPECT_THROW(bob.change_password(secret("not it"), secret("another long phrase"), cheap),
                 DatabaseError);
  }
  EXPECT_THROW(bob.change_password(secret(good_password), secret("another long phrase"), cheap),
               TooSoon);
}

TEST_F(GuardedCourse, KeepsNothingOfWhatWasTyped) {
  refused("my secret phrase in the wrong field");
  EXPECT_EQ(last_audit().text, "");
  refused("ada");
  EXPECT_EQ(last_audit().subject_id, std::to_string(id_of("ada").number));
  EXPECT_EQ(last_audit().text, "");
}

}  // namespace

}  // namespace hallux::database
