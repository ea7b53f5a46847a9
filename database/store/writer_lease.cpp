#include "database/store/writer_lease.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

#include "database/store/files.h"

namespace hallux::database {

namespace {

std::filesystem::path lock_file(const std::filesystem::path& directory, const AttemptId& attempt) {
  return directory / "writers" / (attempt.text + ".lock");
}

}  // namespace

WriterLease WriterLease::take(const std::filesystem::path& directory, AttemptId attempt) {
  make_private_directory(directory / "writers");
  std::filesystem::path file = lock_file(directory, attempt);
  const int descriptor = ::open(file.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
  if (descriptor < 0) throw file_error(file, "make the lock file", errno);
  if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0) {
    const int error_number = errno;
    ::close(descriptor);
    throw file_error(file, "lock", error_number);
  }
  return {std::move(file), std::move(attempt), descriptor};
}

bool WriterLease::is_held(const std::filesystem::path& directory,
                          const AttemptId& attempt) noexcept {
  const int descriptor = ::open(lock_file(directory, attempt).c_str(), O_RDWR | O_CLOEXEC);
  // Where the file cannot even be looked at, an attempt of a live writer must not be marked.
  if (descriptor < 0) return errno != ENOENT;
  const bool is_free = ::flock(descriptor, LOCK_EX | LOCK_NB) == 0;
  ::close(descriptor);
  return !is_free;
}

void WriterLease::clear(const std::filesystem::path& directory, const AttemptId& attempt) noexcept {
  ::unlink(lock_file(directory, attempt).c_str());
}

WriterLease::WriterLease(std::filesystem::path file, AttemptId attempt, int descriptor)
    : file_(std::move(file)), attempt_(std::move(attempt)), descriptor_(descriptor) {}

WriterLease::WriterLease(WriterLease&& other) noexcept
    : file_(std::move(other.file_)),
      attempt_(std::move(other.attempt_)),
      descriptor_(std::exchange(other.descriptor_, -1)) {}

WriterLease& WriterLease::operator=(WriterLease&& other) noexcept {
  if (this != &other) {
    release();
    file_ = std::move(other.file_);
    attempt_ = std::move(other.attempt_);
    descriptor_ = std::exchange(other.descriptor_, -1);
  }
  return *this;
}

WriterLease::~WriterLease() { release(); }

void WriterLease::release() noexcept {
  if (descriptor_ < 0) return;
  ::unlink(file_.c_str());
  ::close(descriptor_);
  descriptor_ = -1;
}

}  // namespace hallux::database
