/// Folder of backups: its names, its lock, its room, and clearing what a stopped backup left.
/// Inside this room only.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "database/store/connection.h"

namespace hallux::database {

/// While it lives, no other process writes into this folder or removes from it.
class BackupFolder {
 public:
  enum class Wait { No, Yes };
  /// Makes the folder (0700) where it is missing, takes its lock and clears what a stopped backup
  /// left.
  /// errors  DatabaseError: Locked where another process has it and is not waited for; BadInput
  ///         where its place for recordings is a link; storage failures
  explicit BackupFolder(std::filesystem::path folder, Wait wait = Wait::No);
  ~BackupFolder();
  BackupFolder(const BackupFolder&) = delete;
  BackupFolder& operator=(const BackupFolder&) = delete;

  const std::filesystem::path& path() const noexcept { return folder_; }
  /// "hallux-20260301-142500" for that time, with a number where it is taken.
  std::string free_name(const std::string& utc) const;
  /// Of the recordings that are there.
  std::int64_t recording_bytes() const;
  /// `pretended_free_bytes` is for tests of a disk that fills.
  /// errors  DatabaseError Full where less than twice `bytes` is free for a backup of `database`
  void check_room(const Database& database, std::int64_t bytes,
                  std::optional<std::uintmax_t> pretended_free_bytes = {}) const;

 private:
  void clear() const noexcept;
  std::filesystem::path folder_;
  int lock_ = -1;
};

/// "2026-03-01T14:25:07Z" of "hallux-20260301-142507-2"; "" where it is no name of a backup.
std::string moment_in_name(const std::string& stem);

}  // namespace hallux::database
