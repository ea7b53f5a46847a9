/// Backup before a migration: the whole database of the older schema in one file.
/// Inside this corner only.
#pragma once

#include "database/store/connection.h"

namespace hallux::database {

/// Writes one whole database backups/hallux-DATE-TIME.db into the data directory, where its schema
/// is older than this program's; waits for another process that does so.
/// errors  DatabaseError: Full where less than twice its size is free; Locked where another program
///         keeps it busy; storage failures
void back_up_before_migration(Database& database);

}  // namespace hallux::database
