/// Reading a database where nothing may be written, not even the memory that its log shares.
/// Inside this corner only.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

namespace hallux::database {

/// How SQLite is told to read it: the file itself where no log lies beside it, else a private copy
/// of both, 0700, gone with the last owner.
struct StillFile {
  /// For SQLITE_OPEN_URI.
  std::string uri;
  std::shared_ptr<const std::filesystem::path> copy;
};

/// Whether nothing may be written into the directory, and no writer is there either.
bool is_still(const std::filesystem::path& directory) noexcept;

/// errors  DatabaseError where there is no room for the copy
StillFile still_file(const std::filesystem::path& file);

}  // namespace hallux::database
