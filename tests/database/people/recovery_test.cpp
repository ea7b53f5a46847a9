#include "database/people/recovery.h"

#include <gtest/gtest.h>

#include "tests/database/some_course.h"

namespace hallux::database {

namespace {

class Recovery : public testing::Test, protected SomeCourse {};

TEST_F(Recovery, MakesACodeAndTellsEveryAdministrator) {
  IssuedCode issued = recover_administrator(database(), "root", cheap);
  EXPECT_EQ(last_audit().action, "administrator_recovered");
  EXPECT_FALSE(last_audit().actor);
  EXPECT_NO_THROW(sign_in_as("root"));
  Session root = redeem_code(database(), "root", issued.code, secret("another long phrase"), cheap);
  EXPECT_TRUE(root.administrator());
  for (Session session : {std::move(root), sign_in_as("max")}) {
    ASSERT_EQ(session.notices().size(), 1U);
    EXPECT_EQ(session.notices()[0].kind, NoticeKind::Recovered);
    EXPECT_EQ(session.notices()[0].login, "root");
  }
  EXPECT_EQ(kind_thrown([&] { sign_in_as("root"); }), DatabaseErrorKind::Refused);
}

TEST_F(Recovery, IsForAdministratorsWhoMaySignIn) {
  EXPECT_EQ(kind_thrown([&] { recover_administrator(database(), "ada", cheap); }),
            DatabaseErrorKind::BadInput);
  administrator().set_disabled("max", true);
  EXPECT_EQ(kind_thrown([&] { recover_administrator(database(), "max", cheap); }),
            DatabaseErrorKind::BadInput);
  EXPECT_EQ(kind_thrown([&] { recover_administrator(database(), "zoe", cheap); }),
            DatabaseErrorKind::NotFound);
}

}  // namespace

}  // namespace hallux::database
