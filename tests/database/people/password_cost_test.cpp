#include <gtest/gtest.h>

#include "database/desks/session.h"
#include "tests/database/some_database.h"

namespace hallux::database {

namespace {

TEST(PasswordCost, IsThatOfTheProductWhereNobodyAsksForLess) {
  const TemporaryDirectory temporary;
  Database database = Database::open(temporary.data());
  OpenHouse::enter(database)->add_first_administrator({"ada", "", true},
                                                      secret("a long enough phrase"));
  EXPECT_NO_THROW(sign_in(database, "ada", secret("a long enough phrase")));
  EXPECT_THROW(sign_in(database, "ada", secret("another long phrase")), DatabaseError);
  EXPECT_THROW(sign_in(database, "zoe", secret("a long enough phrase")), DatabaseError);
  const std::string hash = hash_password(secret("a long enough phrase"), {});
  EXPECT_NE(hash.find("$m=65536,t=3,"), std::string::npos) << hash;
}

}  // namespace

}  // namespace hallux::database
