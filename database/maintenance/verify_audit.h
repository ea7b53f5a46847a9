/// Verification of the audit: its chain, and what it names against what is stored.
/// Inside this corner only.
#pragma once

#include "database/maintenance/verify_progress.h"

namespace hallux::database {

/// The chain of the audit, and that what it names as begun, sealed, stored and decided is still so
/// and nothing else is.
/// errors  DatabaseError Damaged; Cancelled
void check_audit(Database& database, VerifyProgress& progress, Verification& found);

}  // namespace hallux::database
