/// A directory for one test, gone with it.
#pragma once

#include <stdlib.h>
#include <unistd.h>

#include <filesystem>
#include <stdexcept>
#include <string>
#include <system_error>

namespace hallux::tests {

enum class Medium {
  /// Where there is such a place: most tests are not about how fast a disk syncs.
  Memory,
  Disk
};

class TemporaryDirectory {
 public:
  explicit TemporaryDirectory(Medium medium = Medium::Memory) {
    std::string pattern = (place_on(medium) / "hallux-XXXXXX").string();
    if (::mkdtemp(pattern.data()) == nullptr) throw std::runtime_error{"no temporary directory"};
    path_ = pattern;
  }
  ~TemporaryDirectory() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryDirectory(const TemporaryDirectory&) = delete;
  TemporaryDirectory& operator=(const TemporaryDirectory&) = delete;

  const std::filesystem::path& path() const noexcept { return path_; }
  /// A data directory inside that does not exist yet.
  std::filesystem::path data() const { return path_ / "data"; }

 private:
  static std::filesystem::path place_on(Medium medium) {
    const std::filesystem::path memory{"/dev/shm"};
    const bool is_there = medium == Medium::Memory && ::access(memory.c_str(), W_OK) == 0;
    return is_there ? memory : std::filesystem::temp_directory_path();
  }

  std::filesystem::path path_;
};

}  // namespace hallux::tests
