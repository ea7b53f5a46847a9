/// Reads a file that the user named, within a bound.
#pragma once

#include <cstddef>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>

namespace hallux::ui {

/// "FILE: WHAT; MEND".
class FileRefused : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The bytes of a regular file. A folder, a pipe or a device is refused before anything is read of
/// it.
/// needs   mebibytes_max > 0
/// errors  FileRefused: missing, not readable, not a regular file, larger than the bound; ends with
///         `mend`
std::string read_small_file(const std::filesystem::path& file, std::size_t mebibytes_max,
                            std::string_view mend);

}  // namespace hallux::ui
