/// File system of a directory: local, or a share that several machines may write to.
/// Inside this corner only.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "database/store/database_error.h"

namespace hallux::database {

/// The name in this mount table (as /proc/self/mountinfo) of the last mount above the absolute
/// `path`; "" where there is none.
std::string file_system_in(std::string_view mount_table, const std::filesystem::path& path);

/// Of the nearest directory above `path` that exists; "" where the system does not say.
std::string file_system_of(const std::filesystem::path& path);

/// Known as shared between machines: "nfs4", "cifs", "fuse.sshfs" ...
bool is_network_share(std::string_view file_system) noexcept;

/// Refuses to write on a network share. `file_system` is its name, or empty: what the system says
/// of `directory`.
/// errors  DatabaseError ReadOnly naming directory, file system and mend
void check_file_system(const std::filesystem::path& directory, std::string file_system);

}  // namespace hallux::database
