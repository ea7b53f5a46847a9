/// Recordings first, one by one, each with its chain checked, so that the snapshot of the tables
/// that follows stays short; then the manifest, which makes a backup of them: what is cut short is
/// none. A recording that was sealed in between goes with the tables, one that was erased in
/// between leaves the list.
#include "database/maintenance/backup.h"

#include <SQLiteCpp/Backup.h>
#include <sqlite3.h>

#include <algorithm>
#include <system_error>
#include <tuple>

#include "database/audit/anchors.h"
#include "database/maintenance/backup_manifest.h"
#include "database/maintenance/erasures.h"
#include "database/maintenance/table_copy.h"
#include "database/recording/attempts.h"
#include "database/recording/erased_recordings.h"
#include "database/recording/recordings.h"
#include "database/store/backup_folder.h"
#include "database/store/durable_file.h"
#include "database/store/own_directory.h"
#include "database/store/sql.h"
#include "simulator/base/progress.h"

namespace hallux::database {

namespace {

namespace fs = std::filesystem;

/// Recordings take the most of a first backup, tables that of the later ones; a bar that moves is
/// enough.
constexpr double part_of_recordings = 0.7, part_of_tables = 0.95;

class BackupProgress {
 public:
  explicit BackupProgress(const Progress& told) : told_(told) {}
  bool goes_on() {
    is_stopped_ = is_stopped_ || (told_ && !told_(part_));
    return !is_stopped_;
  }
  void reach(double part) {
    part_ = part;
    if (!goes_on()) throw Cancelled{"the backup was stopped; none was left"};
  }

 private:
  const Progress& told_;
  double part_ = 0.0;
  bool is_stopped_ = false;
};

/// Sealed, and not erased: their chunks never change any more.
std::vector<AttemptId> closed_recordings(Database& database) {
  return translating(database, "list the closed recordings", [&] {
    return all_of<AttemptId>(database,
                             "SELECT uuid FROM attempt a WHERE seal IS NOT NULL AND NOT EXISTS "
                             "(SELECT 1 FROM erased_recording e WHERE e.attempt_id = a.attempt_id) "
                             "ORDER BY attempt_id");
  });
}

class BackupWriter {
 public:
  BackupWriter(Database source, const fs::path& path, const BackupOptions& options)
      : source_(std::move(source)), folder_(path), options_(options), progress_(options.progress) {
    manifest_.made_utc = utc_now(source_);
    manifest_.name = folder_.free_name(manifest_.made_utc);
    manifest_.directory = own_directory(source_).text;
    anchor_ = text_of(take_anchor(source_));
  }

  Backup write() {
    const std::int64_t there = folder_.recording_bytes();
    folder_.check_room(source_, std::max<std::int64_t>(page_bytes(source_) - there, 0),
                       options_.pretended_free_bytes);
    write_recordings();
    write_tables();
    progress_.reach(part_of_tables);
    const fs::path file = folder_.path() / (manifest_.name + ".json");
    add_to_journal(journal_in(folder_.path()), known_erasures());
    write_manifest(file, manifest_);
    if (options_.progress) options_.progress(1.0);
    Backup backup{file, manifest_.made_utc, manifest_.directory, manifest_.tables_bytes};
    backup.new_bytes = manifest_.tables_bytes + folder_.recording_bytes() - there;
    backup.recordings = static_cast<std::int64_t>(manifest_.recordings.size());
    for (const BackedUpRecording& kept : manifest_.recordings) backup.bytes += kept.bytes;
    backup.damaged = static_cast<std::int64_t>(manifest_.damaged.size());
    backup.anchor = anchor_;
    return backup;
  }

 private:
  /// Before the snapshot, so that it stays short; what is sealed meanwhile goes with the tables.
  void write_recordings() {
    const std::vector<AttemptId> attempts = closed_recordings(source_);
    for (std::size_t i = 0; i < attempts.size(); ++i) {
      progress_.reach(part_of_recordings * static_cast<double>(i) /
                      static_cast<double>(attempts.size()));
      keep(attempts[i]);
    }
    files_.put_in_place();
    progress_.reach(part_of_recordings);
  }

  void keep(const AttemptId& attempt) {
    try {
      std::error_code error;
      // One that is there was checked when it was written.
      if (!fs::exists(recording_file(folder_.path(), attempt), error)) {
        check_.check(load_header(source_, attempt));
        // Erased in the meantime: the tables say so.
        if (erased_recording(source_, attempt)) return;
      }
      manifest_.recordings.push_back(files_.add(source_, attempt));
    } catch (const DatabaseError& error) {
      if (error.kind() != DatabaseErrorKind::Damaged) throw;
      manifest_.damaged.push_back(attempt);
    }
  }

  /// Inside the snapshot: what was erased since its file was written does not belong to this
  /// backup.
  std::vector<AttemptId> left_out() {
    const std::vector<AttemptId> closed = closed_recordings(source_);
    const auto is_gone = [&](const BackedUpRecording& kept) {
      return std::find(closed.begin(), closed.end(), kept.attempt) == closed.end();
    };
    std::erase_if(manifest_.recordings, is_gone);
    std::vector<AttemptId> attempts;
    for (const BackedUpRecording& kept : manifest_.recordings) attempts.push_back(kept.attempt);
    return attempts;
  }

  void write_tables() {
    const fs::path file = folder_.path() / (manifest_.name + ".tables");
    const fs::path unfinished = file.string() + ".part";
    copy_tables(
        source_, unfinished, [this] { return left_out(); }, [this] { return progress_.goes_on(); });
    progress_.reach(part_of_recordings);
    const DigestedFile written = digest_of_file(unfinished);
    manifest_.tables = written.digest;
    manifest_.tables_bytes = written.bytes;
    sync_file(unfinished);
    put_in_place(unfinished, file);
  }

  std::vector<JournalLine> known_erasures() {
    std::vector<JournalLine> lines = read_journal(journal_in(source_.directory() / "backups"));
    for (const JournalLine& line : list_erasures(source_)) {
      const auto is_same = [&](const JournalLine& known) {
        return known.person == line.person && known.directory == line.directory;
      };
      if (std::none_of(lines.begin(), lines.end(), is_same)) lines.push_back(line);
    }
    return lines;
  }

  Database source_;
  BackupFolder folder_;
  const BackupOptions& options_;
  BackupProgress progress_;
  RecordingCheck check_{source_};
  NewRecordingFiles files_{folder_.path()};
  BackupManifest manifest_;
  std::string anchor_;
};

std::optional<Backup> backup_in(const fs::path& file) {
  const std::string moment = moment_in_name(file.stem().string());
  if (moment.empty()) return std::nullopt;
  Backup backup{file, moment};
  std::error_code error;
  if (file.extension() == ".db") {
    const std::uintmax_t bytes = fs::file_size(file, error);
    backup.bytes = error ? 0 : static_cast<std::int64_t>(bytes);
    return backup;
  }
  if (file.extension() != ".json") return std::nullopt;
  try {
    const BackupManifest manifest = read_manifest(file);
    backup.recordings = static_cast<std::int64_t>(manifest.recordings.size());
    backup.damaged = static_cast<std::int64_t>(manifest.damaged.size());
    backup.directory = manifest.directory;
    backup.bytes = manifest.tables_bytes;
    for (const BackedUpRecording& kept : manifest.recordings) backup.bytes += kept.bytes;
    return backup;
  } catch (const DatabaseError&) {
    return std::nullopt;  // what is no complete backup is not offered as one
  }
}

}  // namespace

Backup back_up(Database& database, const fs::path& folder, const BackupOptions& options) {
  return BackupWriter{database.open_again(), folder, options}.write();
}

std::vector<Backup> list_backups(const fs::path& folder) {
  std::vector<Backup> backups;
  std::error_code error;
  for (fs::directory_iterator entry{folder, error}, end; !error && entry != end;
       entry.increment(error)) {
    if (auto backup = backup_in(entry->path())) backups.push_back(std::move(*backup));
  }
  std::sort(backups.begin(), backups.end(), [](const Backup& a, const Backup& b) {
    // "-2" and "-10" behind a name count those of one second.
    const std::string name_a = a.file.stem().string(), name_b = b.file.stem().string();
    return std::tuple{a.made_utc, name_a.size(), name_a} >
           std::tuple{b.made_utc, name_b.size(), name_b};
  });
  return backups;
}

void copy_whole(Database& source, Database& target) {
  translating(target, "copy a database", [&] {
    SQLite::Backup backup{target.connection(), source.connection()};
    if (backup.executeStep(-1) == SQLITE_DONE) return;
    throw DatabaseError{DatabaseErrorKind::Locked,
                        "could not write " + target.file().string() +
                            ": another program keeps it busy; close that program and try again"};
  });
}

}  // namespace hallux::database
