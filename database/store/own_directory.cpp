#include "database/store/own_directory.h"

#include "database/store/sql.h"

namespace hallux::database {

DirectoryId own_directory(Database& database) {
  return translating(database, "read which directory this is", [&] {
    SQLite::Statement row{database.connection(), "SELECT uuid FROM directory"};
    row.executeStep();
    return DirectoryId{row.getColumn(0).getString()};
  });
}

}  // namespace hallux::database
