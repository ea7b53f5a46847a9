#include "database/people/hand_settings.h"

#include <gtest/gtest.h>

#include "database/maintenance/erasures.h"
#include "database/maintenance/verify.h"
#include "database/store/sql.h"
#include "simulator/base/progress.h"
#include "tests/database/some_course.h"

namespace hallux::database {

namespace {

TEST(HandSettings, AreThePersonsWhereverTheySignIn) {
  SomeCourse course;
  EXPECT_EQ(course.trainee("ada").hand_settings(), HandSettings{});
  const HandSettings chosen{true, 1500, 250};
  course.trainee("ada").choose_hand(chosen);
  EXPECT_EQ(course.trainee("ada").hand_settings(), chosen);
  EXPECT_EQ(course.trainee("bob").hand_settings(), HandSettings{});
  course.trainee("ada").choose_hand({});
  EXPECT_EQ(course.trainee("ada").hand_settings(), HandSettings{});
}

TEST(HandSettings, WhatCannotBeIsRefusedAndNothingIsKept) {
  SomeCourse course;
  for (const HandSettings& wrong :
       {HandSettings{false, 249}, HandSettings{false, 4001}, HandSettings{false, std::nullopt, -1},
        HandSettings{false, std::nullopt, 1001}}) {
    try {
      course.trainee("ada").choose_hand(wrong);
      ADD_FAILURE();
    } catch (const DatabaseError& error) {
      EXPECT_EQ(error.kind(), DatabaseErrorKind::BadInput);
      EXPECT_NE(std::string{error.what()}.find("thousandths"), std::string::npos) << error.what();
    }
  }
  EXPECT_EQ(course.trainee("ada").hand_settings(), HandSettings{});
}

TEST(HandSettings, AreAnActAndAccountedFor) {
  SomeCourse course;
  course.trainee("ada").choose_hand({true});
  EXPECT_EQ(
      single<int>(course.database(), "SELECT count(*) FROM audit WHERE action = 'hand_chosen'"), 1);
  EXPECT_TRUE(verify(course.database()).is_whole());
  tamper(course.database(), "UPDATE hand_setting SET is_left_handed = 0");
  EXPECT_NE(verify(course.database()).first_damage.value_or("").find("hand_setting"),
            std::string::npos);
}

TEST(HandSettings, GoWithAPersonWhoIsErased) {
  SomeCourse course;
  course.trainee("ada").choose_hand({true, 2000, 500});
  erase_person(course.database(), {course.id_of("ada"), false, "asked for it"},
               course.id_of("root"));
  EXPECT_EQ(single<int>(course.database(), "SELECT count(*) FROM hand_setting"), 0);
  EXPECT_TRUE(verify(course.database()).is_whole());
}

}  // namespace

}  // namespace hallux::database
