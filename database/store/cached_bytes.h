/// What can be made anew from what is recorded, kept so that it need not be: files in the folder `cache` of the data
/// directory. The folder may be deleted at any time; nothing is lost with it, and nothing in it is sealed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "simulator/base/digest.h"

namespace hallux::database {

/// What is kept under that name and was made from what `key` digests; nothing where there is none, where it was made from
/// something else, or where a bit of it differs from what was written.
/// thread  any; another process may write the same name
std::optional<std::vector<std::byte>> load_kept(const std::filesystem::path& data_directory,
                                                const std::string& name, const Digest& key);

/// Keeps the bytes, 0600 and compressed, whole or not at all; then lets go of the files that were not written for longest
/// until the folder holds `bytes_max` at most.
/// needs   a name of letters, digits, dots and hyphens
/// errors  DatabaseError of the kinds that a disk causes; what was kept before stays
void keep_bytes(const std::filesystem::path& data_directory, const std::string& name,
                const Digest& key, std::span<const std::byte> bytes,
                std::int64_t bytes_max = std::int64_t{256} << 20U);

/// Where a recording is erased, what was made from it goes as well.
void drop_kept(const std::filesystem::path& data_directory, const std::string& name);

}  // namespace hallux::database
