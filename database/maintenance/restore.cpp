/// A new directory is filled beside its name and gets the name at the end: whole or not at all.
/// Order: tables, recordings, erasures of the journal, then every check that `hallux verify` makes.
/// A schema with other triggers or tables than ours is refused before rows are written into it.
#include "database/maintenance/restore.h"

#include <optional>
#include <set>
#include <system_error>
#include <tuple>

#include "database/audit/audit.h"
#include "database/maintenance/backup_manifest.h"
#include "database/maintenance/erasures.h"
#include "database/maintenance/table_copy.h"
#include "database/maintenance/verify.h"
#include "database/store/backup_folder.h"
#include "database/store/durable_file.h"
#include "database/store/fresh_directory.h"
#include "database/store/own_directory.h"
#include "database/store/sql.h"
#include "simulator/base/progress.h"

namespace hallux::database {

namespace {

namespace fs = std::filesystem;

constexpr const char* stopped = "restoring was stopped; nothing was left";
constexpr double part_of_tables = 0.1, part_of_recordings = 0.6, part_of_checks = 0.98;
/// The first schema in which a directory has a uuid.
constexpr int schema_with_identity = 4;

/// Newest last: by moment, and by the number behind names of one second.
std::tuple<std::string, std::size_t, std::string> age_of(const fs::path& file) {
  const std::string stem = file.stem().string();
  return {moment_in_name(stem), stem.size(), stem};
}

/// What was asked for: a manifest, a whole database, or the newest of a folder. A newest one that
/// is damaged is not passed over in silence: reading it says so.
fs::path chosen_backup(const fs::path& asked) {
  std::error_code error;
  if (!fs::is_directory(asked, error)) return asked;
  fs::path newest;
  for (const fs::directory_entry& entry : fs::directory_iterator{asked}) {
    const fs::path& file = entry.path();
    const bool is_backup = file.extension() == ".json" || file.extension() == ".db";
    if (!is_backup || moment_in_name(file.stem().string()).empty()) continue;
    if (newest.empty() || age_of(file) > age_of(newest)) newest = file;
  }
  if (!newest.empty()) return newest;
  throw DatabaseError{DatabaseErrorKind::NotFound,
                      "there is no complete backup in " + asked.string() + "; check the name"};
}

int schema_of(const fs::path& file) {
  try {
    SQLite::Database raw{file.string(), SQLite::OPEN_READONLY};
    SQLite::Statement row{raw, "PRAGMA user_version"};
    row.executeStep();
    return row.getColumn(0).getInt();
  } catch (const SQLite::Exception& error) {
    throw translated(error, "read the backup", file);
  }
}

/// Triggers or tables of somebody else's making would run with our rights.
void check_schema_is_ours(Database& database, const fs::path& workplace, const fs::path& backup) {
  const fs::path fresh_directory = workplace / "as-made";
  const std::string ours = [&] {
    Database fresh = Database::open(fresh_directory);
    return schema_text(fresh);
  }();
  std::error_code ignored;
  fs::remove_all(fresh_directory, ignored);
  if (schema_text(database) != ours) {
    fail_backup(backup, "its tables are not those that this program makes");
  }
}

class Restorer {
 public:
  Restorer(const RestoreOrder& order, const Progress& progress)
      : order_(order), progress_(progress), workplace_(order.directory) {
    restored_.backup = chosen_backup(order.backup);
  }

  Restored restore() {
    report(0.0);
    restored_.backup.extension() == ".db" ? take_whole_database() : take_tables();
    {
      OpenOptions options;
      options.backs_up_before_migration = false;  // the backup is still there
      Database database = Database::open(workplace_.path(), options);
      check_schema_is_ours(database, workplace_.path(), restored_.backup);
      if (manifest_) put_recordings_back(database);
      apply_erasures(database);
      check_all(database);
      restored_.attempts = count_attempts(database);
      const std::string name = restored_.backup.filename().string();
      append_audit(database, {std::nullopt, "backup_restored", "database", "", false, {}, name});
      clear_log(database);
    }
    sync_file(workplace_.path() / "hallux.db");
    workplace_.finish();
    if (progress_) progress_(1.0);
    return restored_;
  }

 private:
  void report(double part) const {
    cancelled_as(stopped, [&] { hallux::report(progress_, part); });
  }

  fs::path folder() const { return restored_.backup.parent_path(); }
  fs::path database_file() const { return workplace_.path() / "hallux.db"; }

  void take_whole_database() {
    copy_digested(restored_.backup, database_file());
    restored_.made_utc = moment_in_name(restored_.backup.stem().string());
    had_identity_ = schema_of(database_file()) >= schema_with_identity;
  }

  void take_tables() {
    manifest_ = read_manifest(restored_.backup);
    restored_.made_utc = manifest_->made_utc;
    const fs::path tables = folder() / (manifest_->name + ".tables");
    const DigestedFile copied = copy_digested(tables, database_file());
    if (copied.bytes != manifest_->tables_bytes || copied.digest != manifest_->tables) {
      fail_backup(tables, "its bytes do not give the digest that the manifest says");
    }
    report(part_of_tables);
  }

  void put_recordings_back(Database& database) {
    if (own_directory(database).text != manifest_->directory) {
      fail_backup(restored_.backup, "the tables are of another directory");
    }
    // What is lost with the power is made anew: it has no name yet.
    database.connection().exec("PRAGMA synchronous = OFF");
    const double total = static_cast<double>(manifest_->recordings.size());
    for (const BackedUpRecording& kept : manifest_->recordings) {
      report(part_of_tables + (part_of_recordings - part_of_tables) *
                                  static_cast<double>(restored_.recordings) / total);
      put_back(database, kept);
      ++restored_.recordings;
    }
  }

  void put_back(Database& database, const BackedUpRecording& kept) {
    try {
      put_recording_back(database, kept, folder());
    } catch (const DatabaseError& error) {
      if (!order_.even_damaged || is_storage_failure_of_target(error.kind())) throw;
      note_damage(error.what());
    }
  }

  static bool is_storage_failure_of_target(DatabaseErrorKind kind) {
    return kind != DatabaseErrorKind::Damaged && is_storage_failure(kind);
  }

  void note_damage(const std::string& sentence) {
    if (!restored_.first_damage) restored_.first_damage = sentence;
  }

  /// Of the journal beside the backup, and of a newer one.
  std::vector<JournalLine> known_erasures() const {
    std::vector<JournalLine> lines = read_journal(journal_in(folder()));
    if (order_.journal.empty()) return lines;
    if (!fs::exists(order_.journal)) {
      throw DatabaseError{DatabaseErrorKind::NotFound,
                          "there is no journal " + order_.journal.string() + "; check the name"};
    }
    const std::vector<JournalLine> newer = read_journal(order_.journal);
    lines.insert(lines.end(), newer.begin(), newer.end());
    return lines;
  }

  void apply_erasures(Database& database) {
    const std::vector<JournalLine> lines = known_erasures();
    std::set<std::string> directories;
    for (const JournalLine& line : lines) directories.insert(line.directory);
    if (!had_identity_ && directories.size() > 1) {
      throw DatabaseError{DatabaseErrorKind::Refused,
                          "the journal of erasures in " + folder().string() +
                              " is of several directories, and this old backup does not say which "
                              "one it is of; put it into a folder with the journal of its own"};
    }
    restored_.erased_people = apply_journal(database, lines, !had_identity_);
    if (!lines.empty()) add_to_journal(journal_in(workplace_.path() / "backups"), lines);
    report(part_of_recordings);
  }

  void check_all(Database& database) {
    const Verification found = cancelled_as(stopped, [&] {
      return verify(database, part_of(progress_, part_of_recordings, part_of_checks));
    });
    if (found.is_whole()) return;
    if (order_.even_damaged) return note_damage(*found.first_damage);
    throw DatabaseError{
        DatabaseErrorKind::Damaged,
        "nothing was restored from " + restored_.backup.string() + ": " + *found.first_damage};
  }

  static std::int64_t count_attempts(Database& database) {
    return single<std::int64_t>(database, "SELECT count(*) FROM attempt");
  }

  const RestoreOrder& order_;
  const Progress& progress_;
  FreshDirectory workplace_;
  Restored restored_;
  std::optional<BackupManifest> manifest_;
  bool had_identity_ = true;
};

}  // namespace

Restored restore(const RestoreOrder& order, const Progress& progress) {
  return Restorer{order, progress}.restore();
}

}  // namespace hallux::database
