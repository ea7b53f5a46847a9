/// Attempts as files for other programs, with bones and pieces as PLY and the plan as JSON; and
/// such files taken in, scored here.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "database/desks/administrator_desk.h"
#include "ui/jobs/attempt_jobs.h"

namespace hallux::ui {

/// What is made from a record for other programs: the bone and the pieces that the record leaves of
/// it, as PLY, and the plan on this bone (see plan_file), where the scenario fits it.
/// errors  ScenarioError, MeshError
std::vector<database::DerivedFile> files_made_from(const database::ExportMaterial& material);

using FindDesk = std::function<database::AttemptDesk(const database::AttemptId&)>;

struct ExportRequest {
  std::vector<database::AttemptId> attempts;
  /// New, or empty, and outside the data directory.
  std::filesystem::path folder, data_directory;
};

/// Writes a folder for each attempt into a fresh one, which gets its name when all are there.
/// errors  DatabaseError, ScenarioError, MeshError; Cancelled: nothing was left
void export_attempts(const ExportRequest& request, const FindDesk& desk_of,
                     const StageProgress& progress);

struct RefusedFolder {
  std::string folder, reason;
};

struct ImportReport {
  std::vector<database::AttemptId> imported, known;
  std::vector<RefusedFolder> refused;
  /// Of those that were taken in and not with all that their manifest said: why.
  std::vector<std::string> not_all;
};

/// Takes in what export_attempts wrote; a folder that is refused is named, and the others are taken
/// in. Sealed attempts are scored by this program's rubric.
/// errors  DatabaseError: Refused where the desk may not; storage failures; BadInput where there is
///         no export at all. Cancelled: each attempt is here wholly or not at all
ImportReport import_attempts(database::AdministratorDesk& desk, const std::filesystem::path& folder,
                             const StageProgress& progress);

}  // namespace hallux::ui
