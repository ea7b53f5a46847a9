/// Which attempts somebody may export.
#pragma once

#include <string>
#include <vector>

#include "database/desks/session.h"
#include "database/records/attempt.h"

namespace hallux::database {

/// What is asked for; of nothing of it, all.
struct ExportChoice {
  std::string login;   ///< whose; "" for everybody's
  std::string cohort;  ///< of the trainees of the cohort of that name; "" for any
};

/// Those that fit the choice and that one of the session's desks may export, oldest first. A login, a cohort and an attempt
/// that one may not know are as if they were not there.
/// errors  DatabaseError
std::vector<AttemptId> exportable_attempts(Database& database, Session& session,
                                           const ExportChoice& choice);

}  // namespace hallux::database
