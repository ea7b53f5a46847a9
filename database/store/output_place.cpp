#include "database/store/output_place.h"

#include <string>
#include <system_error>

#include "database/store/database_error.h"

namespace hallux::database {

namespace {

namespace fs = std::filesystem;

bool is_same_file(const fs::path& a, const fs::path& b) {
  std::error_code error;
  return fs::equivalent(a, b, error) && !error;
}

/// Links are followed as far as there is something to follow.
bool lies_in(const fs::path& output, const fs::path& directory) {
  std::error_code error;
  fs::path at = fs::weakly_canonical(fs::absolute(output, error), error);
  if (error) at = output;
  for (;; at = at.parent_path()) {
    if (is_same_file(at, directory)) return true;
    if (at == at.parent_path()) return false;
  }
}

/// A second name of one of its files.
bool is_file_of(const fs::path& output, const fs::path& directory) {
  std::error_code error;
  for (fs::directory_iterator entry{directory, error}, end; !error && entry != end;
       entry.increment(error)) {
    if (is_same_file(output, entry->path())) return true;
  }
  return false;
}

}  // namespace

void check_outside(const fs::path& output, const fs::path& data_directory) {
  if (output.empty()) {
    throw DatabaseError{DatabaseErrorKind::BadInput, "the output has no name; name a place for it"};
  }
  std::error_code error;
  if (data_directory.empty()) return;
  if (!fs::exists(fs::symlink_status(data_directory / "hallux.db", error))) return;
  if (!lies_in(output, data_directory) && !is_file_of(output, data_directory)) return;
  throw DatabaseError{DatabaseErrorKind::BadInput,
                      output.string() + " is in the data directory " + data_directory.string() +
                          ", where only what is kept lies; nothing was written, name a place "
                          "elsewhere"};
}

}  // namespace hallux::database
