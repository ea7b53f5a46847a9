#include "database/store/still_copy.h"

#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <string_view>
#include <system_error>

#include "database/store/durable_file.h"
#include "database/store/files.h"

namespace hallux::database {

namespace {

namespace fs = std::filesystem;

/// As a part of a URI: what means something there is written by its number.
std::string uri_of(const fs::path& file, std::string_view question) {
  constexpr std::string_view digits = "0123456789abcdef", meaning = "%?#";
  std::string uri = "file:";
  for (const char letter : fs::absolute(file).string()) {
    const auto byte = static_cast<unsigned char>(letter);
    if (meaning.find(letter) == std::string_view::npos && byte >= 0x20) {
      uri += letter;
    } else {
      uri.append(1, '%').append(1, digits[byte >> 4U]).append(1, digits[byte & 15U]);
    }
  }
  return uri.append(question);
}

fs::path log_of(const fs::path& file) { return file.string() + "-wal"; }

bool has_log(const fs::path& file) noexcept {
  std::error_code error;
  const std::uintmax_t bytes = fs::file_size(log_of(file), error);
  return !error && bytes > 0;
}

std::shared_ptr<const fs::path> private_folder() {
  std::string name = (fs::temp_directory_path() / "hallux-read-XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) throw named_file_error(name, "make a copy in", errno);
  return {new fs::path(name), [](const fs::path* folder) {
            std::error_code ignored;
            fs::remove_all(*folder, ignored);
            delete folder;
          }};
}

}  // namespace

bool is_still(const fs::path& directory) noexcept {
  const std::string shared = (directory / "hallux.db-shm").string();
  return ::access(directory.c_str(), W_OK) != 0 && ::access(shared.c_str(), R_OK) != 0;
}

StillFile still_file(const fs::path& file) {
  if (!has_log(file)) return {uri_of(file, "?immutable=1"), nullptr};
  const std::shared_ptr<const fs::path> folder = private_folder();
  const fs::path copy = *folder / file.filename();
  copy_digested(file, copy);
  copy_digested(log_of(file), log_of(copy));
  return {uri_of(copy, ""), folder};
}

}  // namespace hallux::database
