/// The one table of who may do what to whose: role x action x relation.
///
/// A role is what a desk stands for, a relation what the person at the desk is to the row. What the table does not allow
/// is refused; each action of each role has exactly one line, so that nothing is left out by oversight.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace hallux::database {

enum class Role : std::uint8_t {
  House,         ///< nobody signed in: what belongs to nobody
  Trainee,       ///< any person, for what is their own
  Instructor,    ///< of one cohort
  Administrator  ///< of the data directory
};
inline constexpr std::size_t role_count = 4;

enum class Action : std::uint8_t {
  BeginAttempt,
  ListAttempts,
  ViewAttempt,  ///< header, recording, score
  StoreScore,
  ChangePassword,  ///< knowing the old one
  SetPassword,     ///< without the old one
  AddPerson,
  ListPeople,
  DisablePerson,
  AddCohort,
  Enrol
};
inline constexpr std::size_t action_count = 11;

enum class Relation : std::uint8_t {
  Own,     ///< the row is this person's, or is this person
  Cohort,  ///< of a trainee of the desk's cohort
  Robot,   ///< of nobody
  Other    ///< of anybody else
};
inline constexpr std::size_t relation_count = 4;

/// Which relations a role may do an action in.
struct PolicyLine {
  Role role;
  Action action;
  bool own, cohort, robot, other;
};

inline constexpr std::array<PolicyLine, role_count * action_count> policy{{
    //                                             own    cohort robot  other
    {Role::House, Action::BeginAttempt, false, false, true, false},
    {Role::House, Action::ListAttempts, false, false, true, false},
    {Role::House, Action::ViewAttempt, false, false, true, false},
    {Role::House, Action::StoreScore, false, false, true, false},
    {Role::House, Action::ChangePassword, false, false, false, false},
    {Role::House, Action::SetPassword, false, false, false, false},
    {Role::House, Action::AddPerson, false, false, false, false},
    {Role::House, Action::ListPeople, false, false, false, false},
    {Role::House, Action::DisablePerson, false, false, false, false},
    {Role::House, Action::AddCohort, false, false, false, false},
    {Role::House, Action::Enrol, false, false, false, false},
    {Role::Trainee, Action::BeginAttempt, true, false, false, false},
    {Role::Trainee, Action::ListAttempts, true, false, true, false},
    {Role::Trainee, Action::ViewAttempt, true, false, true, false},
    {Role::Trainee, Action::StoreScore, true, false, false, false},
    {Role::Trainee, Action::ChangePassword, true, false, false, false},
    {Role::Trainee, Action::SetPassword, false, false, false, false},
    {Role::Trainee, Action::AddPerson, false, false, false, false},
    {Role::Trainee, Action::ListPeople, false, false, false, false},
    {Role::Trainee, Action::DisablePerson, false, false, false, false},
    {Role::Trainee, Action::AddCohort, false, false, false, false},
    {Role::Trainee, Action::Enrol, false, false, false, false},
    {Role::Instructor, Action::BeginAttempt, false, false, false, false},
    {Role::Instructor, Action::ListAttempts, false, true, true, false},
    {Role::Instructor, Action::ViewAttempt, false, true, true, false},
    {Role::Instructor, Action::StoreScore, false, true, true, false},
    {Role::Instructor, Action::ChangePassword, true, false, false, false},
    {Role::Instructor, Action::SetPassword, false, false, false, false},
    {Role::Instructor, Action::AddPerson, false, false, false, false},
    {Role::Instructor, Action::ListPeople, false, false, false, false},
    {Role::Instructor, Action::DisablePerson, false, false, false, false},
    {Role::Instructor, Action::AddCohort, false, false, false, false},
    {Role::Instructor, Action::Enrol, false, false, false, false},
    {Role::Administrator, Action::BeginAttempt, false, false, false, false},
    {Role::Administrator, Action::ListAttempts, false, false, true, false},
    {Role::Administrator, Action::ViewAttempt, false, false, true, false},
    {Role::Administrator, Action::StoreScore, false, false, true, false},
    {Role::Administrator, Action::ChangePassword, true, false, false, false},
    {Role::Administrator, Action::SetPassword, true, false, false, true},
    {Role::Administrator, Action::AddPerson, false, false, false, true},
    {Role::Administrator, Action::ListPeople, false, false, false, true},
    {Role::Administrator, Action::DisablePerson, true, false, false, true},
    {Role::Administrator, Action::AddCohort, false, false, false, true},
    {Role::Administrator, Action::Enrol, true, false, false, true},
}};

constexpr bool allows(Role role, Action action, Relation relation) noexcept {
  for (const PolicyLine& line : policy) {
    if (line.role != role || line.action != action) continue;
    const std::array<bool, relation_count> allowed{line.own, line.cohort, line.robot, line.other};
    return allowed[static_cast<std::size_t>(relation)];
  }
  return false;
}

}  // namespace hallux::database
