/// The manifest of a backup: what belongs to it, with digests. A backup whose manifest is there is complete.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "database/maintenance/recording_file.h"

namespace hallux::database {

inline constexpr std::int64_t backup_format = 1;

struct BackupManifest {
  std::string name;       ///< "hallux-20260301-142507", of the manifest and of the file of tables
  std::string directory;  ///< the uuid of the directory that was backed up
  std::string made_utc;
  std::int64_t tables_bytes = 0;
  Digest tables;                          ///< of the bytes of that file
  std::vector<KeptRecording> recordings;  ///< which are not among the tables' rows
  std::vector<AttemptId> damaged;         ///< whose chunks are among the rows, as they were found
};

/// Whether it may stand in a file's name: 36 of 0-9 a-f and dashes.
bool is_uuid(const std::string& text) noexcept;

/// On the disk and complete when it returns.
/// errors  DatabaseError: storage failures
void write_manifest(const std::filesystem::path& file, const BackupManifest& manifest);

/// errors  DatabaseError: NotFound; Damaged where it was altered; Newer; BadInput for a link or what is no manifest
BackupManifest read_manifest(const std::filesystem::path& file);

}  // namespace hallux::database
