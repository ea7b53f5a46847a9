#include "database/maintenance/open_maintenance.h"

#include "database/people/people.h"
#include "simulator/base/progress.h"

namespace hallux::database {

std::optional<OpenMaintenance> OpenMaintenance::enter(Database& database) {
  if (has_people(database)) return std::nullopt;
  return OpenMaintenance{database};
}

void OpenMaintenance::require_nobody() const {
  if (!has_people(*database_)) return;
  throw DatabaseError{DatabaseErrorKind::Refused,
                      "somebody was added to " + database_->file().string() +
                          " in the meantime; an administrator must do this"};
}

Backup OpenMaintenance::back_up(const std::filesystem::path& directory, const Progress& progress) {
  require_nobody();
  return back_up_with_rotation(*database_,
                               directory.empty() ? database_->directory() / "backups" : directory,
                               std::nullopt, {progress, {}});
}

std::vector<Backup> OpenMaintenance::backups() {
  require_nobody();
  return list_backups(database_->directory() / "backups");
}

RetentionRules OpenMaintenance::retention() {
  require_nobody();
  return load_retention(*database_);
}

void OpenMaintenance::set_retention(const RetentionRules& rules) {
  require_nobody();
  store_retention(*database_, rules);
}

std::vector<RetentionPiece> OpenMaintenance::retention_plan() {
  require_nobody();
  return plan_retention(*database_);
}

RetentionDone OpenMaintenance::retain(const Progress& progress) {
  require_nobody();
  return apply_retention(*database_, std::nullopt, progress);
}

}  // namespace hallux::database
