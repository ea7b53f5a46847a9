/// What is left of a password in the memory of this process once it was used.

#include <gtest/gtest.h>

#include "tests/database/some_course.h"
#include "tests/support/own_memory.h"

namespace hallux::database {

namespace {

SecretText taken(const PlantedSecret& planted) {
  std::string spelled = planted.spelled();
  return SecretText::take(spelled);
}

class Memory : public testing::Test, protected SomeCourse {};

TEST_F(Memory, HoldsAPasswordInOnePlaceWhileItIsUsed) {
  const PlantedSecret planted;
  EXPECT_EQ(planted.places_in_memory(), 0U);
  {
    const SecretText secret = taken(planted);
    EXPECT_EQ(planted.places_in_memory(), 1U);
  }
  EXPECT_EQ(planted.places_in_memory(), 0U);
}

TEST_F(Memory, HoldsNoPasswordAfterASignIn) {
  const PlantedSecret planted;
  administrator().set_password("ada", taken(planted), cheap);
  Session ada = sign_in(database(), "ada", taken(planted), cheap);
  EXPECT_EQ(planted.places_in_memory(), 0U);
  EXPECT_THROW(sign_in(database(), "bob", taken(planted), cheap), DatabaseError);
  EXPECT_THROW(sign_in(database(), "zoe", taken(planted), cheap), DatabaseError);
  EXPECT_EQ(planted.places_in_memory(), 0U);
}

TEST_F(Memory, HoldsNoPasswordAfterItWasChanged) {
  const PlantedSecret before, after;
  administrator().set_password("ada", taken(before), cheap);
  Session ada = sign_in(database(), "ada", taken(before), cheap);
  ada.change_password(taken(before), taken(after), cheap);
  ada.prove(taken(after), cheap);
  EXPECT_EQ(before.places_in_memory(), 0U);
  EXPECT_EQ(after.places_in_memory(), 0U);
}

TEST_F(Memory, HoldsNoCodeAfterItWasRedeemed) {
  const PlantedSecret planted;
  IssuedCode issued = administrator().reset("ada", cheap);
  redeem_code(database(), "ada", issued.code, taken(planted), cheap);
  EXPECT_EQ(planted.places_in_memory(), 0U);
}

}  // namespace

}  // namespace hallux::database
