#include "database/store/fresh_directory.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "database/store/durable_file.h"
#include "database/store/files.h"
#include "database/store/output_place.h"

namespace hallux::database {

namespace {

namespace fs = std::filesystem;

fs::path without_slash(const fs::path& path) {
  return path.has_filename() ? path : path.parent_path();
}

fs::path target_for(const fs::path& directory, const fs::path& data_directory) {
  check_outside(directory, data_directory);
  return without_slash(fs::absolute(directory));
}

}  // namespace

FreshDirectory::FreshDirectory(const fs::path& directory, const fs::path& data_directory)
    : target_(target_for(directory, data_directory)),
      path_(target_.parent_path() / ("." + target_.filename().string() + ".unfinished")),
      lock_file_(path_.string() + ".lock") {
  check_target_is_free();
  std::error_code error;
  fs::create_directories(target_.parent_path(), error);
  if (error) throw named_file_error(target_.parent_path(), "make the directory", error.value());
  lock_ = ::open(lock_file_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0600);
  if (lock_ < 0) throw named_file_error(lock_file_, "make the lock file", errno);
  if (::flock(lock_, LOCK_EX | LOCK_NB) != 0) {
    ::close(lock_);
    throw DatabaseError{DatabaseErrorKind::Locked,
                        "another process is making " + target_.string() + " already"};
  }
  clear();
  if (::mkdir(path_.c_str(), 0700) == 0) return;
  const int error_number = errno;
  ::close(lock_);
  throw named_file_error(path_, "make the directory", error_number);
}

FreshDirectory::~FreshDirectory() {
  clear();
  std::error_code ignored;
  fs::remove(lock_file_, ignored);
  ::close(lock_);
}

void FreshDirectory::finish() const {
  check_target_is_free();
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(path_)) {
    if (entry.is_directory()) sync_directory(entry.path());
  }
  sync_directory(path_);
  put_in_place(path_, target_);
}

void FreshDirectory::check_target_is_free() const {
  std::error_code error;
  const fs::file_status status = fs::symlink_status(target_, error);
  if (!fs::exists(status) || (fs::is_directory(status) && fs::is_empty(target_, error))) return;
  throw DatabaseError{DatabaseErrorKind::Refused,
                      target_.string() +
                          " holds something already, and nothing was written; name a directory "
                          "that is new or empty"};
}

void FreshDirectory::clear() const noexcept {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

}  // namespace hallux::database
