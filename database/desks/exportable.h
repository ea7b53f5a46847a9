/// Attempts that a signed-in person may export.
#pragma once

#include <string>
#include <vector>

#include "database/desks/session.h"
#include "database/records/attempt.h"

namespace hallux::database {

/// What is asked for; of nothing of it, all.
struct ExportChoice {
  /// Whose; "" for everybody's.
  std::string login;
  /// Of the trainees of the cohort of that name; "" for any.
  std::string cohort;
};

/// Those that fit the choice and that one of the session's desks may export, oldest first. A login,
/// a cohort and an attempt that one may not know are as if they were not there.
/// errors  DatabaseError
std::vector<AttemptId> exportable_attempts(Database& database, Session& session,
                                           const ExportChoice& choice);

}  // namespace hallux::database
