/// Origins of imported attempts, and whether what comes from there counts here.
/// Inside this room only.
#pragma once

#include <optional>
#include <vector>

#include "database/records/origin.h"
#include "database/store/connection.h"

namespace hallux::database {

/// Oldest first.
std::vector<Origin> list_origins(Database& database);

/// The number of the origin's row; made where attempts come from there for the first time.
/// needs   the caller's transaction
/// errors  DatabaseError BadInput where `directory` is no identity
std::int64_t note_origin(Database& database, const DirectoryId& directory);

/// Who that origin's person of that number is here: a person without details, who cannot sign in;
/// made where they come for the first time.
/// needs   the caller's transaction
PersonId note_origin_person(Database& database, std::int64_t origin, PersonId there);

/// errors  DatabaseError Refused where that person of the origin was erased here: what was erased
///         does not come back
void refuse_erased(Database& database, std::int64_t origin, PersonId there);

/// What was imported from there counts from now on, or no longer. Nothing of it is changed.
/// errors  DatabaseError NotFound
void set_accepted(Database& database, const DirectoryId& directory, bool is_accepted);

}  // namespace hallux::database
