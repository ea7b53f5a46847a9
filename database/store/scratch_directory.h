/// Scratch directory inside a data directory: what is made there gets its name when it is whole.
/// Inside this corner only.
#pragma once

#include <filesystem>

namespace hallux::database {

/// One of its own, ".new-XXXXXX", 0700 and gone with its owner; those that killed processes left
/// are cleared when the next is made.
class ScratchDirectory {
 public:
  /// errors  DatabaseError
  explicit ScratchDirectory(const std::filesystem::path& directory);
  ~ScratchDirectory();
  ScratchDirectory(const ScratchDirectory&) = delete;
  ScratchDirectory& operator=(const ScratchDirectory&) = delete;

  const std::filesystem::path& path() const noexcept { return path_; }

 private:
  std::filesystem::path path_;
  /// Holds the lock that tells it from one that was left.
  int descriptor_ = -1;
};

}  // namespace hallux::database
