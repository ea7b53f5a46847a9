/// Cohorts: who is trainee and instructor in which. The desks decide who may call what.
/// Inside this room only.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "database/records/course.h"
#include "database/store/connection.h"

namespace hallux::database {

/// errors  DatabaseError BadInput where the name is empty or taken
CohortId create_cohort(Database& database, const std::string& name);

/// By name.
std::vector<Cohort> list_cohorts(Database& database);
/// errors  DatabaseError NotFound
Cohort load_cohort(Database& database, CohortId id);
/// Instructors first, then by login.
std::vector<CohortMember> list_members(Database& database, CohortId id);

/// Puts a person into a cohort, or changes what they are there. Who is that already keeps the day
/// of their enrolment.
/// errors  DatabaseError NotFound
void enrol(Database& database, CohortId cohort, PersonId person, CohortRole role);
/// Takes a person out; their attempts stay theirs.
/// errors  DatabaseError NotFound where the person is not in the cohort
void remove_from_cohort(Database& database, CohortId cohort, PersonId person);

/// Nothing where the person is not in the cohort.
std::optional<CohortRole> role_in(Database& database, CohortId cohort, PersonId person);
/// By name of the cohort.
std::vector<Membership> memberships_of(Database& database, PersonId person);

}  // namespace hallux::database
