#include "database/store/own_directory.h"

#include "database/store/sql.h"

namespace hallux::database {

DirectoryId own_directory(Database& database) {
  return translating(database, "read which directory this is",
                     [&] { return single<DirectoryId>(database, "SELECT uuid FROM directory"); });
}

}  // namespace hallux::database
