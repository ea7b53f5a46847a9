/// The identity of a data directory: made with its database, copied with its backups, named by its
/// exports. Inside this room only.
#pragma once

#include "database/records/ids.h"
#include "database/store/connection.h"

namespace hallux::database {

/// errors  DatabaseError
DirectoryId own_directory(Database& database);

}  // namespace hallux::database
