/// Virtual tables of SQL over chunks: pose_samples(attempt), tape_lines(attempt),
/// cut_events(attempt). Inside this corner only.
///
///   SELECT tick, tool_x_in_world_um FROM pose_samples('3f...') WHERE tick BETWEEN 60000 AND 60009
///
/// Table-valued functions of SQLite: each row is read from its chunk when it is asked for, and its
/// chunk's link is checked. Bounds on `tick` decide which windows are opened at all. Rows come by
/// rising tick. An attempt that is not there has no rows; a damaged chunk ends the statement with
/// SQLITE_CORRUPT and the chunk's place.
/// source  docs/data_format.md; https://www.sqlite.org/vtab.html
#pragma once

#include "database/store/connection.h"

namespace hallux::database {

/// Makes the three known on the connection of `database`.
/// needs   `database` is not moved afterwards
/// errors  DatabaseError
void add_record_tables(Database& database);

}  // namespace hallux::database
