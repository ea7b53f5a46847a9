#include "database/store/schema_backup.h"

#include <SQLiteCpp/Backup.h>
#include <sqlite3.h>

#include "database/store/backup_folder.h"
#include "database/store/durable_file.h"
#include "database/store/files.h"
#include "database/store/migrations.h"
#include "database/store/sql.h"

namespace hallux::database {

namespace fs = std::filesystem;

void back_up_before_migration(Database& database) {
  const fs::path folder = database.directory() / "backups";
  const BackupFolder locked{folder, BackupFolder::Wait::Yes};
  if (!is_of_older_schema(database)) return;
  locked.check_room(database, page_bytes(database));
  const fs::path file = folder / (locked.free_name(utc_now(database)) + ".db");
  const fs::path unfinished = file.string() + ".part";
  make_private_file(unfinished);
  translating(database, "copy the database", [&] {
    SQLite::Database target{unfinished.string(), SQLite::OPEN_READWRITE, 0, database.vfs_name()};
    {
      SQLite::Backup backup{target, database.connection()};
      if (backup.executeStep(-1) != SQLITE_DONE) {
        throw DatabaseError{DatabaseErrorKind::Locked,
                            "could not copy " + database.file().string() +
                                ": another program keeps it busy; close that program"};
      }
    }
    target.exec("PRAGMA journal_mode = DELETE");
  });
  sync_file(unfinished);
  put_in_place(unfinished, file);
}

}  // namespace hallux::database
