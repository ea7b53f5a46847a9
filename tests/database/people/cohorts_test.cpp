#include "database/people/cohorts.h"

#include <gtest/gtest.h>

#include "tests/database/some_course.h"

namespace hallux::database {

namespace {

class Cohorts : public testing::Test, protected SomeCourse {};

TEST_F(Cohorts, HoldEachPersonInOneRole) {
  const PersonId id = id_of("eve");
  EXPECT_FALSE(role_in(database(), autumn(), id));
  enrol(database(), autumn(), id, CohortRole::Trainee);
  enrol(database(), autumn(), id, CohortRole::Instructor);
  EXPECT_EQ(role_in(database(), autumn(), id), CohortRole::Instructor);
  EXPECT_EQ(role_in(database(), spring(), id), CohortRole::Trainee) << "another in each cohort";
}

TEST_F(Cohorts, CannotShareANameAndNeedOne) {
  constexpr auto bad = DatabaseErrorKind::BadInput;
  EXPECT_EQ(kind_thrown([&] { create_cohort(database(), "autumn"); }), bad);
  EXPECT_EQ(kind_thrown([&] { create_cohort(database(), ""); }), bad);
  EXPECT_EQ(kind_thrown([&] { enrol(database(), {99}, id_of("ada"), CohortRole::Trainee); }),
            DatabaseErrorKind::NotFound);
}

TEST_F(Cohorts, AreListedWithTheirMembers) {
  const auto cohorts = list_cohorts(database());
  ASSERT_EQ(cohorts.size(), 2U);
  EXPECT_EQ(cohorts[0].name, "autumn");
  EXPECT_EQ(cohorts[0].trainees, 3);
  EXPECT_EQ(cohorts[0].instructors, 1);
  const auto members = list_members(database(), autumn());
  ASSERT_EQ(members.size(), 4U);
  EXPECT_EQ(members[0].login, "kim") << "instructors first";
  EXPECT_EQ(members[1].login, "ada");
  EXPECT_FALSE(members[1].enrolled_utc.empty());
}

TEST_F(Cohorts, LetPeopleGo) {
  remove_from_cohort(database(), autumn(), id_of("ada"));
  EXPECT_FALSE(role_in(database(), autumn(), id_of("ada")));
  EXPECT_EQ(kind_thrown([&] { remove_from_cohort(database(), autumn(), id_of("ada")); }),
            DatabaseErrorKind::NotFound);
}

TEST_F(Cohorts, ShowWhatAPersonIsWhere) {
  const auto memberships = sign_in_as("lee").memberships();
  ASSERT_EQ(memberships.size(), 2U);
  EXPECT_EQ(memberships[0].cohort_name, "autumn");
  EXPECT_EQ(memberships[0].role, CohortRole::Trainee);
  EXPECT_EQ(memberships[1].role, CohortRole::Instructor);
}

}  // namespace

}  // namespace hallux::database
