/// Place that somebody named for an output: never inside the data directory.
#pragma once

#include <filesystem>

namespace hallux::database {

/// Refuses an output that is, by whatever name or link, a file of the data directory or lies in it;
/// told apart by device and inode. A directory without a database, or none at all, keeps nothing
/// yet.
/// errors  DatabaseError BadInput naming the output, also where its name is empty
void check_outside(const std::filesystem::path& output,
                   const std::filesystem::path& data_directory);

}  // namespace hallux::database
