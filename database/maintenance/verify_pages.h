/// Verification of the pages: SQLite's own checks, and the indices that reading goes by.
/// Inside this corner only.
#pragma once

#include "database/maintenance/verify_progress.h"

namespace hallux::database {

/// SQLite's own checks, table by table, and of the chunks that each row stands in the indices that
/// reading goes by.
/// errors  DatabaseError Damaged; Cancelled
void check_pages(Database& database, VerifyProgress& progress);

}  // namespace hallux::database
