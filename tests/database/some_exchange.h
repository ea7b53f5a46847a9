/// Exports and imports between directories, for tests.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "database/exchange/export_attempt.h"
#include "database/exchange/import_attempt.h"
#include "tests/database/some_course.h"

namespace hallux::database {

/// Stands for what assessment makes of a record: the same bytes for the same record.
std::vector<DerivedFile> some_derived(const ExportMaterial& material);

/// Every file below `folder` by its path, with its bytes.
std::map<std::string, std::string> bytes_below(const std::filesystem::path& folder);

/// Replaces the first `old_text` in the file; the manifest's digest and size of it are brought up
/// to date.
void alter(const std::filesystem::path& folder, const std::string& name,
           const std::string& old_text, const std::string& new_text);

/// The same, and the manifest is left as it is.
void alter_alone(const std::filesystem::path& file, const std::string& old_text,
                 const std::string& new_text);

/// A course, a folder for what leaves it, and another directory with an administrator.
class TwoDirectories {
 public:
  TwoDirectories();

  SomeCourse& course() noexcept { return course_; }
  Database& there() noexcept { return there_; }
  AdministratorDesk administrator_there();
  /// A folder inside that is there.
  std::filesystem::path out() const { return out_.data().parent_path(); }
  /// Exports from the course; returns the attempt's folder.
  std::filesystem::path exported(const AttemptId& id);
  /// Takes the folder in at the administrator's desk there; `rescored` where the attempt is sealed.
  bool import(const std::filesystem::path& folder);

 private:
  SomeCourse course_;
  TemporaryDirectory temporary_, out_;
  Database there_;
};

}  // namespace hallux::database
