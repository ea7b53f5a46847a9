/// Standings: one row for each person, operation and device class, kept as the attempts, scores and
/// decisions say by triggers of the schema, so that a cohort of a thousand is read at a glance.
/// Inside this room only.
#pragma once

#include <cstdint>
#include <vector>

#include "database/records/course.h"
#include "database/store/connection.h"

namespace hallux::database {

/// By name of the operation.
std::vector<OperationStanding> operation_standings(Database& database, PersonId person);

/// The trainees of the cohort by login, disabled ones too, each with at most `attempts_max` of
/// their newest attempts.
std::vector<TraineeStanding> list_standings(Database& database, CohortId cohort,
                                            std::int32_t attempts_max);
/// One of them.
/// errors  DatabaseError NotFound where the person is no trainee of the cohort
TraineeStanding load_standing(Database& database, CohortId cohort, PersonId trainee,
                              std::int32_t attempts_max);

/// Counts all of them anew from the attempts.
void recount_standings(Database& database);
/// errors  DatabaseError Damaged where one differs from what is counted, naming it
void check_standings(Database& database);

}  // namespace hallux::database
