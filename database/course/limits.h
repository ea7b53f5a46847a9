/// Limits of assessments: set for a cohort and an operation, asked where an attempt begins. The
/// desks decide who may call what. Inside this room only.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "database/records/attempt.h"
#include "database/records/ids.h"
#include "database/records/limit.h"
#include "database/store/connection.h"

namespace hallux::database {

inline constexpr std::int32_t attempts_max_most = 1000;

/// By name of the operation.
std::vector<AttemptLimit> list_limits(Database& database, CohortId cohort);

/// Takes the place of the one before. The audit row names cohort, operation and number.
/// errors  DatabaseError: NotFound for an unknown cohort or operation; BadInput where it is not 1
///         to attempts_max_most
void set_limit(Database& database, CohortId cohort, const AttemptLimit& limit, PersonId by);
/// errors  DatabaseError NotFound where there is none
void clear_limit(Database& database, CohortId cohort, const std::string& scenario_name,
                 PersonId by);

/// Nothing where no cohort in which the person is a trainee limits the operation.
std::optional<AttemptAllowance> allowance_of(Database& database, PersonId person,
                                             const std::string& scenario_name);

/// To be asked in the transaction that stores the attempt, so that two windows of one person cannot
/// both begin the last one.
/// errors  DatabaseError Refused, saying how many were used and who can change it
void check_allowance(Database& database, const NewAttempt& attempt);

}  // namespace hallux::database
