#include "database/maintenance/open_maintenance.h"

#include "database/people/people.h"
#include "simulator/base/progress.h"

namespace hallux::database {

std::optional<OpenKeeping> OpenKeeping::enter(Database& database) {
  if (has_people(database)) return std::nullopt;
  return OpenKeeping{database};
}

void OpenKeeping::require_nobody() const {
  if (!has_people(*database_)) return;
  throw DatabaseError{DatabaseErrorKind::Refused,
                      "somebody was added to " + database_->file().string() +
                          " in the meantime; an administrator must do this"};
}

Backup OpenKeeping::back_up(const std::filesystem::path& directory, const Progress& progress) {
  require_nobody();
  return keep_backup(*database_, directory.empty() ? database_->directory() / "backups" : directory,
                     std::nullopt, {progress, {}});
}

std::vector<Backup> OpenKeeping::backups() {
  require_nobody();
  return list_backups(database_->directory() / "backups");
}

RetentionRules OpenKeeping::retention() {
  require_nobody();
  return load_retention(*database_);
}

void OpenKeeping::set_retention(const RetentionRules& rules) {
  require_nobody();
  store_retention(*database_, rules);
}

std::vector<RetentionPiece> OpenKeeping::retention_plan() {
  require_nobody();
  return plan_retention(*database_);
}

RetentionDone OpenKeeping::retain(const Progress& progress) {
  require_nobody();
  return apply_retention(*database_, std::nullopt, progress);
}

}  // namespace hallux::database
