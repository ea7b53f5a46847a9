/// Maintenance of a data directory without people: what an administrator's desk does for others.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "database/maintenance/backup_rotation.h"
#include "database/maintenance/retention.h"
#include "simulator/base/progress.h"

namespace hallux::database {

/// errors  of all methods: DatabaseError Refused once somebody was added; as in the files that are
///         included
class OpenMaintenance {
 public:
  /// Nothing where there are people.
  static std::optional<OpenMaintenance> enter(Database& database);

  Backup back_up(const std::filesystem::path& directory = {}, const Progress& progress = {});
  std::vector<Backup> backups();
  RetentionRules retention();
  void set_retention(const RetentionRules& rules);
  std::vector<RetentionPiece> retention_plan();
  RetentionDone retain(const Progress& progress = {});

 private:
  explicit OpenMaintenance(Database& database) : database_(&database) {}
  void require_nobody() const;
  Database* database_;
};

}  // namespace hallux::database
