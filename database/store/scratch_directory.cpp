#include "database/store/scratch_directory.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <string>
#include <system_error>
#include <vector>

#include "database/store/files.h"

namespace hallux::database {

namespace {

namespace fs = std::filesystem;

constexpr const char* name_start = ".new-";

/// Opened and locked; -1 where it is gone or somebody's.
int locked(const fs::path& directory) {
  const int descriptor = ::open(directory.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
  if (descriptor < 0) return -1;
  struct stat opened {
  }, named{};
  const bool is_ours = ::flock(descriptor, LOCK_EX | LOCK_NB) == 0 &&
                       ::fstat(descriptor, &opened) == 0 &&
                       ::lstat(directory.c_str(), &named) == 0 && opened.st_ino == named.st_ino;
  if (is_ours) return descriptor;
  ::close(descriptor);
  return -1;
}

void remove_locked(const fs::path& directory, int descriptor) {
  std::error_code ignored;
  fs::remove_all(directory, ignored);
  ::close(descriptor);
}

void clear_left(const fs::path& directory) {
  std::vector<fs::path> left;
  std::error_code error;
  for (fs::directory_iterator entry{directory, error}, end; !error && entry != end;
       entry.increment(error)) {
    if (entry->path().filename().string().starts_with(name_start)) left.push_back(entry->path());
  }
  for (const fs::path& one : left) {
    if (const int descriptor = locked(one); descriptor >= 0) remove_locked(one, descriptor);
  }
}

}  // namespace

ScratchDirectory::ScratchDirectory(const fs::path& directory) {
  clear_left(directory);
  // Another process that clears may have it before it is locked here: then the next one.
  while (descriptor_ < 0) {
    std::string name = (directory / (std::string{name_start} + "XXXXXX")).string();
    if (::mkdtemp(name.data()) == nullptr) throw file_error(directory, "write into", errno);
    path_ = name;
    descriptor_ = locked(path_);
  }
}

ScratchDirectory::~ScratchDirectory() { remove_locked(path_, descriptor_); }

}  // namespace hallux::database
