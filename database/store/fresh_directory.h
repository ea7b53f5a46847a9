/// Fresh directory that gets its name when all of it is there: a restored one, an export.
#pragma once

#include <filesystem>

namespace hallux::database {

/// While it is made it is a hidden one beside the place it gets, ".NAME.unfinished"; gone where it
/// is not finished. A lock tells one that is being made from one that a kill left, which is
/// cleared.
class FreshDirectory {
 public:
  /// Makes the directories it lies in where they are missing. `data_directory`: it may not lie
  /// there; empty: it is itself one.
  /// errors  DatabaseError: Refused where the directory holds something; Locked where another
  ///         process makes it; BadInput where nothing can have this name; storage failures
  explicit FreshDirectory(const std::filesystem::path& directory,
                          const std::filesystem::path& data_directory = {});
  ~FreshDirectory();
  FreshDirectory(const FreshDirectory&) = delete;
  FreshDirectory& operator=(const FreshDirectory&) = delete;

  /// Where to write, 0700.
  const std::filesystem::path& path() const noexcept { return path_; }
  /// Gives it its name once all directories in it lie on the disk. Asks once more whether the name
  /// is free: something may have been put there meanwhile.
  /// needs   every file in it was synced by its writer
  /// errors  as the constructor
  void finish() const;

 private:
  void check_target_is_free() const;
  void clear() const noexcept;

  std::filesystem::path target_, path_, lock_file_;
  int lock_ = -1;
};

}  // namespace hallux::database
