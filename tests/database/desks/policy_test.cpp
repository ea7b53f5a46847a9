#include "database/desks/policy.h"

#include <gtest/gtest.h>

#include <string>

namespace hallux::database {

namespace {

constexpr std::array<Role, role_count> roles{Role::House, Role::Trainee, Role::Instructor,
                                             Role::Administrator};

/// "o" own, "c" cohort, "r" robot, "x" other.
std::string letters(Role role, Action action) {
  std::string text;
  for (std::size_t i = 0; i < relation_count; ++i) {
    if (allows(role, action, static_cast<Relation>(i))) text.push_back("ocrx"[i]);
  }
  return text.empty() ? "-" : text;
}

TEST(Policy, HasOneLineForEachAction) {
  for (std::size_t action = 0; action < action_count; ++action) {
    int lines = 0;
    for (const PolicyLine& line : policy) lines += line.action == static_cast<Action>(action);
    EXPECT_EQ(lines, 1) << action;
  }
}

/// Written down a second time and by hand: whoever changes the table changes this too, and says so
/// in the commit.
TEST(Policy, IsThis) {
  constexpr std::array<std::array<const char*, role_count>, action_count> expected{{
      // house, trainee, instructor, administrator
      {"r", "o", "-", "-"},      // BeginAttempt
      {"r", "or", "cr", "r"},    // ListAttempts
      {"r", "or", "cr", "r"},    // ViewAttempt
      {"r", "o", "cr", "r"},     // StoreScore
      {"-", "o", "-", "-"},      // ListOperations
      {"-", "o", "c", "-"},      // ReadNotes
      {"-", "-", "c", "-"},      // ReadPrivateNotes
      {"-", "-", "c", "-"},      // WriteNote
      {"-", "o", "c", "-"},      // ReplyToNote
      {"-", "o", "-", "-"},      // AskForHelp
      {"-", "o", "c", "-"},      // ReadHelp
      {"-", "-", "c", "-"},      // AnswerHelp
      {"-", "-", "c", "-"},      // DecideResult
      {"-", "-", "c", "-"},      // SeeCohort
      {"-", "o", "o", "o"},      // ChangePassword
      {"-", "-", "-", "ox"},     // SetPassword
      {"-", "-", "-", "x"},      // IssueCode
      {"-", "-", "-", "x"},      // AddPerson
      {"-", "-", "-", "x"},      // ListPeople
      {"-", "-", "-", "ox"},     // DisablePerson
      {"-", "-", "-", "ox"},     // CorrectName
      {"-", "-", "-", "ox"},     // ChangeRole
      {"-", "-", "-", "x"},      // AddCohort
      {"-", "-", "-", "x"},      // ListCohorts
      {"-", "-", "-", "ox"},     // Enrol
      {"-", "-", "-", "x"},      // ListScenarios
      {"-", "-", "-", "x"},      // ImportScenario
      {"-", "-", "-", "x"},      // PublishScenario
      {"-", "-", "-", "x"},      // RetireScenario
      {"-", "-", "-", "x"},      // ReadAudit
      {"-", "-", "-", "x"},      // BackUp
      {"-", "-", "-", "x"},      // ListOrigins
      {"-", "-", "-", "x"},      // AcceptOrigin
      {"-", "o", "-", "x"},      // ReadNotices
      {"-", "-", "-", "x"},      // ChangeSettings
      {"-", "-", "-", "x"},      // ErasePerson
      {"-", "o", "-", "ox"},     // ExportPerson
      {"-", "-", "-", "x"},      // Retain
      {"-", "-", "c", "x"},      // LimitAttempts
      {"-", "o", "c", "-"},      // CompareWithCohort
      {"-", "-", "-", "x"},      // RunReport
      {"r", "or", "cr", "orx"},  // ExportAttempt
      {"-", "-", "-", "x"},      // ImportAttempt
      {"-", "o", "-", "-"},      // ChooseHand
  }};
  for (std::size_t action = 0; action < action_count; ++action) {
    for (const Role role : roles) {
      EXPECT_EQ(letters(role, static_cast<Action>(action)),
                expected[action][static_cast<std::size_t>(role)])
          << "action " << action << ", role " << static_cast<int>(role);
    }
  }
}

TEST(Policy, KnowsACohortAtTheInstructorsDeskOnly) {
  for (const PolicyLine& line : policy) {
    for (const Role role : roles) {
      if (role != Role::Instructor) {
        EXPECT_FALSE(allows(role, line.action, Relation::Cohort));
      }
    }
  }
}

TEST(Policy, LetsNobodyDoAnythingAboutTheAttemptOfAStranger) {
  for (const Action action :
       {Action::BeginAttempt, Action::ListAttempts, Action::ViewAttempt, Action::StoreScore,
        Action::ReadNotes, Action::ReadPrivateNotes, Action::WriteNote, Action::ReplyToNote,
        Action::AskForHelp, Action::ReadHelp, Action::AnswerHelp, Action::DecideResult}) {
    for (const Role role : roles) EXPECT_FALSE(allows(role, action, Relation::Other));
  }
}

TEST(Policy, LetsNobodyNoteOrDecideAboutTheRobotOrThemselves) {
  for (const Action action : {Action::WriteNote, Action::DecideResult, Action::SeeCohort,
                              Action::AnswerHelp, Action::ReadPrivateNotes}) {
    for (const Role role : roles) {
      EXPECT_FALSE(allows(role, action, Relation::Robot));
      EXPECT_FALSE(allows(role, action, Relation::Own));
    }
  }
}

}  // namespace

}  // namespace hallux::database
