/// Verification of the rows themselves: the schema as this program makes it, and each row as the
/// audit says. Inside this corner only.
#pragma once

#include "database/maintenance/verify_progress.h"

namespace hallux::database {

/// Tables, indices, triggers and views against those of the schema that the file says it has.
/// errors  DatabaseError Damaged
void check_schema(Database& database);

/// Each row of each table that acts account for.
/// errors  DatabaseError Damaged; Cancelled
void check_rows(Database& database, VerifyProgress& progress, Verification& found);

}  // namespace hallux::database
