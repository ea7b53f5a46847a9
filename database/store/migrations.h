/// Migrations to the newest schema, one numbered file of database/schema at a time.
/// Inside this room only.
#pragma once

#include <string>

#include "database/store/connection.h"

namespace hallux::database {

/// The schema this program writes: the number of files in database/schema.
std::int32_t newest_schema() noexcept;

/// Looks at the file without changing it.
/// errors  DatabaseError: Newer where the file's schema is newer than this program; Damaged where
///         it is empty or not ours
void check_schema_is_known(Database& database);

/// Whether there is something to migrate; a file without any schema has nothing.
bool is_of_older_schema(Database& database);

/// The statements of schema file `index`, from 0.
std::string schema_statements(std::int32_t index);

/// Applies what is missing, each file in one transaction with its PRAGMA user_version; safe against
/// a second process.
void migrate(Database& database);

}  // namespace hallux::database
