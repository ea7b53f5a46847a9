/// Of each day, week and month the newest backup stays, for as many of them as the rule says, and
/// the newest few in any case. Backups share their recordings: one goes when no manifest of the
/// folder names it any more, also none of another directory, and none at all while a manifest there
/// cannot be read.
#include "database/maintenance/backup_rotation.h"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <set>

#include "database/audit/audit.h"
#include "database/maintenance/backup_manifest.h"
#include "database/people/notices.h"
#include "database/store/backup_folder.h"
#include "database/store/durable_file.h"
#include "database/store/files.h"
#include "database/store/output_place.h"
#include "database/store/own_directory.h"
#include "database/store/settings.h"
#include "database/store/sql.h"

namespace hallux::database {

namespace {

namespace fs = std::filesystem;

int number_setting(Database& database, const char* name, int shipped, int least) {
  const std::optional<std::string> text = read_setting(database, name);
  int number = shipped;
  if (text) std::from_chars(text->data(), text->data() + text->size(), number);
  return std::clamp(number, least, rotation_most);
}

int part_of(const std::string& utc, std::size_t at, std::size_t count) {
  int number = 0;
  if (utc.size() >= at + count) {
    std::from_chars(utc.data() + at, utc.data() + at + count, number);
  }
  return number;
}

/// The Monday of the week that a moment lies in, as days since 1970.
int week_of(const std::string& utc) {
  using namespace std::chrono;
  const sys_days day =
      year_month_day{year{part_of(utc, 0, 4)}, month{static_cast<unsigned>(part_of(utc, 5, 2))},
                     std::chrono::day{static_cast<unsigned>(part_of(utc, 8, 2))}};
  return static_cast<int>((day - (weekday{day} - Monday)).time_since_epoch().count());
}

/// Keeps the newest of each of the first `count` different periods.
template <typename PeriodOf>
void keep_of_each(std::span<const std::string> made_utc, int count, std::vector<bool>& kept,
                  PeriodOf&& period_of) {
  std::set<std::string> periods;
  for (std::size_t i = 0; i < made_utc.size(); ++i) {
    if (static_cast<int>(periods.size()) >= count) return;
    if (periods.insert(period_of(made_utc[i])).second) kept[i] = true;
  }
}

void remove_file(const fs::path& file) {
  std::error_code error;
  fs::remove(file, error);
  if (error) throw file_error(file, "remove", error.value());
}

/// The manifest first: what is left without one is no backup, and the next one clears it.
void remove_backup(const Backup& backup) {
  remove_file(backup.file);
  sync_directory(backup.file.parent_path());
  if (backup.file.extension() == ".json")
    remove_file(fs::path{backup.file}.replace_extension(".tables"));
}

/// What any manifest of the folder names, also of another directory; nothing where one cannot be
/// read.
std::optional<std::set<std::string>> named_recordings(const fs::path& folder) {
  std::set<std::string> named;
  for (const fs::directory_entry& entry : fs::directory_iterator{folder}) {
    if (entry.path().extension() != ".json") continue;
    try {
      for (const BackedUpRecording& kept : read_manifest(entry.path()).recordings) {
        named.insert(kept.attempt.text);
      }
    } catch (const DatabaseError&) {
      return std::nullopt;
    }
  }
  return named;
}

void remove_unnamed_recordings(const fs::path& folder) {
  const auto named = named_recordings(folder);
  if (!named) return;
  std::vector<fs::path> unnamed;
  for (const fs::directory_entry& entry : fs::directory_iterator{folder / "recordings"}) {
    const fs::path& file = entry.path();
    if (file.extension() != ".recording" || !is_uuid(file.stem().string())) continue;
    if (!named->contains(file.stem().string())) unnamed.push_back(file);
  }
  for (const fs::path& file : unnamed) remove_file(file);
}

void audit_files(Database& database, std::optional<PersonId> actor, const char* action,
                 const std::vector<fs::path>& files) {
  for (const fs::path& file : files) {
    append_audit(database, {actor, action, "database", "", false, {}, file.filename().string()});
  }
}

}  // namespace

RotationRule load_rotation(Database& database) {
  const RotationRule shipped;
  return {number_setting(database, "backups_newest", shipped.newest, 1),
          number_setting(database, "backups_days", shipped.days, 0),
          number_setting(database, "backups_weeks", shipped.weeks, 0),
          number_setting(database, "backups_months", shipped.months, 0)};
}

std::vector<bool> kept_by(const RotationRule& rule, std::span<const std::string> made_utc) {
  std::vector<bool> kept(made_utc.size(), false);
  for (std::size_t i = 0; i < made_utc.size(); ++i) {
    kept[i] = i == 0 || static_cast<int>(i) < rule.newest;
  }
  keep_of_each(made_utc, rule.days, kept, [](const std::string& utc) { return utc.substr(0, 10); });
  keep_of_each(made_utc, rule.weeks, kept,
               [](const std::string& utc) { return std::to_string(week_of(utc)); });
  keep_of_each(made_utc, rule.months, kept,
               [](const std::string& utc) { return utc.substr(0, 7); });
  return kept;
}

std::vector<fs::path> rotate_backups(Database& database, const fs::path& folder,
                                     const RotationRule& rule) {
  const BackupFolder locked{folder};
  const std::string directory = own_directory(database).text;
  std::vector<Backup> own = list_backups(folder);
  const bool is_own_folder = folder == database.directory() / "backups";
  std::erase_if(own, [&](const Backup& backup) {
    return backup.file.extension() == ".db" ? !is_own_folder : backup.directory != directory;
  });
  std::vector<std::string> made_utc;
  made_utc.reserve(own.size());
  for (const Backup& backup : own) made_utc.push_back(backup.made_utc);
  const std::vector<bool> kept = kept_by(rule, made_utc);
  std::vector<fs::path> removed;
  for (std::size_t i = 0; i < own.size(); ++i) {
    if (kept[i]) continue;
    remove_backup(own[i]);
    removed.push_back(own[i].file);
  }
  remove_unnamed_recordings(folder);
  return removed;
}

Backup back_up_with_rotation(Database& database, const fs::path& asked,
                             std::optional<PersonId> actor, const BackupOptions& options) {
  const fs::path usual = database.directory() / "backups";
  const fs::path folder = asked.empty() ? usual : asked;
  std::error_code ignored;
  const bool is_usual = folder == usual || fs::equivalent(folder, usual, ignored);
  if (!is_usual) check_outside(folder, database.directory());
  Backup backup;
  try {
    backup = back_up(database, folder, options);
  } catch (const DatabaseError& error) {
    if (error.kind() == DatabaseErrorKind::Full) {
      in_transaction(database, "tell of a skipped backup", [&] {
        tell_administrators(database, NoticeKind::BackupSkipped);
        append_audit(database, {actor, "backup_made", "database", "", true, {}, error.what()});
      });
    }
    throw;
  }
  audit_files(database, actor, "backup_made", {backup.file});
  audit_files(database, actor, "backup_removed",
              rotate_backups(database, folder, load_rotation(database)));
  return backup;
}

}  // namespace hallux::database
