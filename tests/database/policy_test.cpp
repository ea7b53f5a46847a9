#include "database/policy.h"

#include <gtest/gtest.h>

namespace hallux::database {

namespace {

TEST(Policy, HasOneLineForEachActionOfEachRole) {
  for (std::size_t role = 0; role < role_count; ++role) {
    for (std::size_t action = 0; action < action_count; ++action) {
      int lines = 0;
      for (const PolicyLine& line : policy) {
        lines += line.role == static_cast<Role>(role) && line.action == static_cast<Action>(action);
      }
      EXPECT_EQ(lines, 1) << role << " " << action;
    }
  }
}

TEST(Policy, LetsOnlyAnInstructorSeeATraineesAttempt) {
  for (const Role role : {Role::House, Role::Trainee, Role::Instructor, Role::Administrator}) {
    EXPECT_EQ(allows(role, Action::ViewAttempt, Relation::Cohort), role == Role::Instructor);
    EXPECT_FALSE(allows(role, Action::ViewAttempt, Relation::Other));
    EXPECT_FALSE(allows(role, Action::ListAttempts, Relation::Other));
    EXPECT_FALSE(allows(role, Action::StoreScore, Relation::Other));
  }
}

TEST(Policy, LetsNobodyOperateForSomebodyElse) {
  for (const Role role : {Role::House, Role::Trainee, Role::Instructor, Role::Administrator}) {
    EXPECT_FALSE(allows(role, Action::BeginAttempt, Relation::Other));
    EXPECT_FALSE(allows(role, Action::BeginAttempt, Relation::Cohort));
    EXPECT_EQ(allows(role, Action::BeginAttempt, Relation::Own), role == Role::Trainee);
    EXPECT_EQ(allows(role, Action::BeginAttempt, Relation::Robot), role == Role::House);
  }
}

TEST(Policy, LetsAllSeeTheRobotsAttemptsAndOnlyThoseWhoTeachOrAdministerKeepTheirScores) {
  for (const Role role : {Role::House, Role::Trainee, Role::Instructor, Role::Administrator}) {
    EXPECT_TRUE(allows(role, Action::ListAttempts, Relation::Robot));
    EXPECT_TRUE(allows(role, Action::ViewAttempt, Relation::Robot));
    EXPECT_EQ(allows(role, Action::StoreScore, Relation::Robot), role != Role::Trainee);
  }
}

TEST(Policy, LetsAnAdministratorKeepNoScoreOfAPerson) {
  for (const Relation relation : {Relation::Own, Relation::Cohort, Relation::Other}) {
    EXPECT_FALSE(allows(Role::Administrator, Action::StoreScore, relation));
    EXPECT_FALSE(allows(Role::Administrator, Action::ViewAttempt, relation));
  }
}

TEST(Policy, LeavesPeopleToAdministrators) {
  for (const Action action : {Action::AddPerson, Action::ListPeople, Action::DisablePerson,
                              Action::SetPassword, Action::AddCohort, Action::Enrol}) {
    for (const Role role : {Role::House, Role::Trainee, Role::Instructor}) {
      for (std::size_t i = 0; i < relation_count; ++i) {
        EXPECT_FALSE(allows(role, action, static_cast<Relation>(i)));
      }
    }
    EXPECT_TRUE(allows(Role::Administrator, action, Relation::Other));
  }
}

}  // namespace

}  // namespace hallux::database
