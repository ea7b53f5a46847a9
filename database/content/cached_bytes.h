/// Cache of what can be computed again from what is recorded: files in the folder `cache` of
/// the data directory. The folder may be deleted at any time; nothing is lost with it, and nothing
/// in it is sealed.
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

/// What is cached under that name and was made from what `key` digests; nothing where there is
/// none, where it was made from something else, or where a bit of it differs from what was written.
/// thread  any; another process may write the same name
std::optional<std::vector<std::byte>> load_cached(const std::filesystem::path& data_directory,
                                                  const std::string& name, const Digest& key);

/// Writes the bytes, 0600 and compressed, whole or not at all; then removes the files that were not
/// written for longest until the folder holds `bytes_max` at most.
/// needs   a name of letters, digits, dots and hyphens
/// errors  DatabaseError of the kinds that a disk causes; what was cached before stays
void store_cached(const std::filesystem::path& data_directory, const std::string& name,
                  const Digest& key, std::span<const std::byte> bytes,
                  std::int64_t bytes_max = std::int64_t{256} << 20U);

/// Removes what is cached under that name: where a recording is erased, what was made from it goes
/// as well.
void drop_cached(const std::filesystem::path& data_directory, const std::string& name);

}  // namespace hallux::database
