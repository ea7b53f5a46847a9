/// Private files and directories, with errors as sentences.
#pragma once

#include <filesystem>

#include "database/store/database_error.h"

namespace hallux::database {

/// What `error_number` of the operating system means for a file of the data directory: Full,
/// ReadOnly, InputOutput, or BadInput where the name itself is the mistake.
DatabaseError file_error(const std::filesystem::path& file, const char* tried, int error_number);

/// The same for a file or folder that somebody named for one task: to restore into, to export to,
/// to import from.
DatabaseError named_file_error(const std::filesystem::path& file, const char* tried,
                               int error_number);

/// Makes the directory and its parents; one that was made here, or is ours and empty, gets mode
/// 0700.
/// errors  DatabaseError
void make_private_directory(const std::filesystem::path& directory);

/// Makes the file with mode 0600 where it is missing; takes the rights of others away where it is
/// not.
/// errors  DatabaseError
void make_private_file(const std::filesystem::path& file);
/// Takes the rights of others away where that is permitted. SQLite gives its -wal and -shm files
/// the mode of the file beside them.
void close_to_others(const std::filesystem::path& file) noexcept;

}  // namespace hallux::database
