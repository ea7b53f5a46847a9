/// Manifest of a backup: its files with their digests. A backup that has one is complete.
/// Inside this corner only.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "database/maintenance/recording_file.h"

namespace hallux::database {

inline constexpr std::int64_t backup_format = 1;

struct BackupManifest {
  /// "hallux-20260301-142507", of the manifest and of the file of tables.
  std::string name;
  /// The uuid of the directory that was backed up.
  std::string directory;
  std::string made_utc;
  std::int64_t tables_bytes = 0;
  /// Of the bytes of that file.
  Digest tables;
  /// Which are not among the tables' rows.
  std::vector<BackedUpRecording> recordings;
  /// Whose chunks are among the rows, as they were found.
  std::vector<AttemptId> damaged;
};

/// Whether it may stand in a file's name: 36 of 0-9 a-f and dashes.
bool is_uuid(const std::string& text) noexcept;

/// On the disk and complete when it returns.
/// errors  DatabaseError: storage failures
void write_manifest(const std::filesystem::path& file, const BackupManifest& manifest);

/// errors  DatabaseError: NotFound; Damaged where it was altered; Newer; BadInput for a link or
///         what is no manifest
BackupManifest read_manifest(const std::filesystem::path& file);

}  // namespace hallux::database
