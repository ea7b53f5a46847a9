/// Verification of the scores: their cards, and which of them is in force. Inside this corner only.
#pragma once

#include "database/maintenance/verify_progress.h"

namespace hallux::database {

/// Every score is what its card says, and the newest of an attempt is in force.
/// errors  DatabaseError Damaged; Cancelled
void check_scores(Database& database, VerifyProgress& progress, Verification& found);

/// Every set of measurements has the rows that its digest is of, and no row is of none.
/// errors  as above
void check_measurements(Database& database, VerifyProgress& progress);

}  // namespace hallux::database
