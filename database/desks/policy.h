/// The policy table: role x action x relation. Inside this corner only.
///
/// A role is what a desk stands for, a relation what the person at the desk is to the row. What the
/// table does not allow is refused; each action has exactly one line with an entry for each role,
/// so that nothing is left out by oversight.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace hallux::database {

enum class Role : std::uint8_t {
  /// Nobody signed in: for what belongs to nobody.
  House,
  /// Any person, for what is their own.
  Trainee,
  /// An instructor of one cohort.
  Instructor,
  /// An administrator of the data directory.
  Administrator
};
inline constexpr std::size_t role_count = 4;

/// What somebody asks to do; the name of each in the audit is in desks.cpp.
enum class Action : std::uint8_t {
  BeginAttempt,
  ListAttempts,
  /// Header, recording, what was on the screen, score and decisions of an attempt.
  ViewAttempt,
  StoreScore,
  /// The published operations.
  ListOperations,
  /// The notes that a trainee sees.
  ReadNotes,
  ReadPrivateNotes,
  WriteNote,
  ReplyToNote,
  AskForHelp,
  ReadHelp,
  AnswerHelp,
  /// To confirm, override or void a result.
  DecideResult,
  /// The trainees of a cohort and their standings.
  SeeCohort,
  /// A new password by somebody who knows the old one.
  ChangePassword,
  /// A new password without the old one.
  SetPassword,
  /// A one-time code in place of a password.
  IssueCode,
  AddPerson,
  ListPeople,
  DisablePerson,
  /// To change how a person is called.
  CorrectName,
  /// To make a person an administrator, or no longer one.
  ChangeRole,
  AddCohort,
  ListCohorts,
  /// To put a person into a cohort, and to take them out.
  Enrol,
  ListScenarios,
  ImportScenario,
  PublishScenario,
  RetireScenario,
  ReadAudit,
  BackUp,
  /// The directories that attempts were imported from.
  ListOrigins,
  /// Whether the attempts of an origin count here.
  AcceptOrigin,
  /// Notices, and to acknowledge them.
  ReadNotices,
  /// Settings of the data directory.
  ChangeSettings,
  ErasePerson,
  /// All that is stored of a person.
  ExportPerson,
  /// The clean-up by the retention rules.
  Retain,
  /// How many assessments the trainees of a cohort have.
  LimitAttempts,
  /// The standing of a cohort, nobody by name.
  CompareWithCohort,
  /// Plain SQL over what reports may read.
  RunReport,
  /// An attempt as files for other programs.
  ExportAttempt,
  /// An attempt that another directory exported.
  ImportAttempt,
  /// To say how one holds the saw.
  ChooseHand
};
inline constexpr std::size_t action_count = 44;

/// Whose row it is, seen from the person at the desk.
enum class Relation : std::uint8_t {
  /// This person's, or this person.
  Own,
  /// A trainee's of the desk's cohort.
  Cohort,
  /// Nobody's: the robot's.
  Robot,
  /// Anybody else's; or no person's at all, as a cohort or a scenario.
  Other
};
inline constexpr std::size_t relation_count = 4;

/// A set of relations: one bit for each.
using Relations = std::uint8_t;
constexpr Relations only(Relation relation) noexcept {
  return static_cast<Relations>(1U << static_cast<unsigned>(relation));
}

/// The relations in which each role may do an action.
struct PolicyLine {
  Action action;
  std::array<Relations, role_count> allowed;
};

namespace policy_words {
inline constexpr Relations no = 0;
inline constexpr Relations own = only(Relation::Own);
inline constexpr Relations cohort = only(Relation::Cohort);
inline constexpr Relations robot = only(Relation::Robot);
inline constexpr Relations other = only(Relation::Other);
inline constexpr Relations own_robot = own | robot;
inline constexpr Relations cohort_robot = cohort | robot;
inline constexpr Relations own_other = own | other;
inline constexpr Relations own_robot_other = own | robot | other;
}  // namespace policy_words

inline constexpr std::array<PolicyLine, action_count> make_policy() noexcept {
  using namespace policy_words;
  return {{
      //                          house  trainee    instructor    administrator
      {Action::BeginAttempt, {{robot, own, no, no}}},
      {Action::ListAttempts, {{robot, own_robot, cohort_robot, robot}}},
      {Action::ViewAttempt, {{robot, own_robot, cohort_robot, robot}}},
      {Action::StoreScore, {{robot, own, cohort_robot, robot}}},
      {Action::ListOperations, {{no, own, no, no}}},
      {Action::ReadNotes, {{no, own, cohort, no}}},
      {Action::ReadPrivateNotes, {{no, no, cohort, no}}},
      {Action::WriteNote, {{no, no, cohort, no}}},
      {Action::ReplyToNote, {{no, own, cohort, no}}},
      {Action::AskForHelp, {{no, own, no, no}}},
      {Action::ReadHelp, {{no, own, cohort, no}}},
      {Action::AnswerHelp, {{no, no, cohort, no}}},
      {Action::DecideResult, {{no, no, cohort, no}}},
      {Action::SeeCohort, {{no, no, cohort, no}}},
      {Action::ChangePassword, {{no, own, own, own}}},
      {Action::SetPassword, {{no, no, no, own_other}}},
      {Action::IssueCode, {{no, no, no, other}}},
      {Action::AddPerson, {{no, no, no, other}}},
      {Action::ListPeople, {{no, no, no, other}}},
      {Action::DisablePerson, {{no, no, no, own_other}}},
      {Action::CorrectName, {{no, no, no, own_other}}},
      {Action::ChangeRole, {{no, no, no, own_other}}},
      {Action::AddCohort, {{no, no, no, other}}},
      {Action::ListCohorts, {{no, no, no, other}}},
      {Action::Enrol, {{no, no, no, own_other}}},
      {Action::ListScenarios, {{no, no, no, other}}},
      {Action::ImportScenario, {{no, no, no, other}}},
      {Action::PublishScenario, {{no, no, no, other}}},
      {Action::RetireScenario, {{no, no, no, other}}},
      {Action::ReadAudit, {{no, no, no, other}}},
      {Action::BackUp, {{no, no, no, other}}},
      {Action::ListOrigins, {{no, no, no, other}}},
      {Action::AcceptOrigin, {{no, no, no, other}}},
      {Action::ReadNotices, {{no, own, no, other}}},
      {Action::ChangeSettings, {{no, no, no, other}}},
      {Action::ErasePerson, {{no, no, no, other}}},
      {Action::ExportPerson, {{no, own, no, own_other}}},
      {Action::Retain, {{no, no, no, other}}},
      {Action::LimitAttempts, {{no, no, cohort, other}}},
      {Action::CompareWithCohort, {{no, own, cohort, no}}},
      {Action::RunReport, {{no, no, no, other}}},
      {Action::ExportAttempt, {{robot, own_robot, cohort_robot, own_robot_other}}},
      {Action::ImportAttempt, {{no, no, no, other}}},
      {Action::ChooseHand, {{no, own, no, no}}},
  }};
}

inline constexpr std::array<PolicyLine, action_count> policy = make_policy();

/// Whether the table lets that role do that action to a row in that relation.
constexpr bool allows(Role role, Action action, Relation relation) noexcept {
  for (const PolicyLine& line : policy) {
    if (line.action != action) continue;
    return (line.allowed[static_cast<std::size_t>(role)] & only(relation)) != 0;
  }
  return false;
}

}  // namespace hallux::database
