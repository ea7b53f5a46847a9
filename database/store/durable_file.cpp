/// What must be on the disk before the next step is written with plain descriptors: a stream cannot
/// be synced, and tells of a full disk too late. The folder is synced after a rename, because the
/// name is what a power cut would lose. What is read is opened without following links and without
/// waiting for a pipe.
#include "database/store/durable_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <utility>

#include "database/store/files.h"

namespace hallux::database {

namespace {

constexpr std::size_t bytes_at_once = std::size_t{1} << 20U;

int opened(const std::filesystem::path& file, int flags, const char* tried) {
  const int descriptor = ::open(file.c_str(), flags | O_CLOEXEC, 0600);
  if (descriptor < 0) throw file_error(file, tried, errno);
  return descriptor;
}

/// Every piece of the file, in order.
template <typename Work>
DigestedFile digested(const std::filesystem::path& file, Work&& work) {
  DurableFile read = DurableFile::open_to_read(file);
  std::vector<std::byte> buffer(bytes_at_once);
  Digester digester;
  DigestedFile result;
  for (std::size_t count = read.read(buffer); count > 0; count = read.read(buffer)) {
    const auto piece = std::span{buffer}.first(count);
    digester.add_bytes(piece);
    work(piece);
    result.bytes += static_cast<std::int64_t>(count);
  }
  result.digest = digester.finish();
  return result;
}

}  // namespace

DurableFile::DurableFile(std::filesystem::path file, int descriptor)
    : file_(std::move(file)), descriptor_(descriptor) {}

DurableFile::DurableFile(DurableFile&& other) noexcept
    : file_(std::move(other.file_)), descriptor_(std::exchange(other.descriptor_, -1)) {}

DurableFile::~DurableFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

DurableFile DurableFile::create(const std::filesystem::path& file) {
  return {file, opened(file, O_WRONLY | O_CREAT | O_TRUNC | O_NOFOLLOW, "write")};
}

DurableFile DurableFile::open_to_append(const std::filesystem::path& file) {
  DurableFile appended{file, opened(file, O_RDWR | O_CREAT | O_APPEND | O_NOFOLLOW, "add to")};
  if (::flock(appended.descriptor_, LOCK_EX) != 0) throw file_error(file, "lock", errno);
  return appended;
}

DurableFile DurableFile::open_to_read(const std::filesystem::path& file) {
  // Not blocking: a pipe that somebody put there must not make us wait.
  const int descriptor = ::open(file.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  if (descriptor < 0 && errno == ENOENT) {
    throw DatabaseError{DatabaseErrorKind::NotFound,
                        "there is no file " + file.string() + "; check the name"};
  }
  struct stat facts {};
  const bool is_link = descriptor < 0 && errno == ELOOP;
  if (descriptor < 0 && !is_link) throw file_error(file, "read", errno);
  DurableFile read{file, descriptor};
  if (is_link || ::fstat(descriptor, &facts) != 0 || !S_ISREG(facts.st_mode)) {
    throw DatabaseError{DatabaseErrorKind::BadInput,
                        file.string() +
                            " is a link or no plain file; it is not followed, put the "
                            "file itself there"};
  }
  return read;
}

void DurableFile::write(std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) throw file_error(file_, "write", errno);
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
}

std::size_t DurableFile::read(std::span<std::byte> bytes) {
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t count = ::read(descriptor_, bytes.data() + done, bytes.size() - done);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) throw file_error(file_, "read", errno);
    if (count == 0) break;
    done += static_cast<std::size_t>(count);
  }
  return done;
}

std::int64_t DurableFile::bytes() const {
  struct stat facts {};
  if (::fstat(descriptor_, &facts) != 0) throw file_error(file_, "read", errno);
  return facts.st_size;
}

void DurableFile::skip_to(std::int64_t bytes) {
  if (::lseek(descriptor_, bytes, SEEK_SET) != bytes) throw file_error(file_, "read", errno);
}

void DurableFile::cut_to(std::int64_t bytes) {
  if (::ftruncate(descriptor_, bytes) != 0) throw file_error(file_, "cut", errno);
}

void DurableFile::sync() {
  if (::fsync(descriptor_) != 0) throw file_error(file_, "write", errno);
}

void sync_directory(const std::filesystem::path& directory) {
  const int descriptor = opened(directory, O_RDONLY | O_DIRECTORY, "read");
  const int answer = ::fsync(descriptor);
  const int error_number = errno;
  ::close(descriptor);
  // Some file systems cannot sync a directory and say so; they need not.
  if (answer != 0 && error_number != EINVAL) throw file_error(directory, "write", error_number);
}

void name_finished(const std::filesystem::path& finished, const std::filesystem::path& file) {
  if (::rename(finished.c_str(), file.c_str()) != 0) throw file_error(file, "name", errno);
}

void put_in_place(const std::filesystem::path& finished, const std::filesystem::path& file) {
  name_finished(finished, file);
  sync_directory(file.parent_path());
}

bool put_in_free_place(const std::filesystem::path& finished, const std::filesystem::path& file) {
  // Where there are no links (FAT), the other call can do the same.
  const bool is_placed = ::link(finished.c_str(), file.c_str()) == 0 ||
                         (errno == EPERM && ::renameat2(AT_FDCWD, finished.c_str(), AT_FDCWD,
                                                        file.c_str(), RENAME_NOREPLACE) == 0);
  if (!is_placed && errno != EEXIST) throw file_error(file, "name", errno);
  sync_directory(file.parent_path());
  return is_placed;
}

std::vector<std::byte> read_plain_file(const std::filesystem::path& file, std::int64_t bytes_max) {
  DurableFile opened_file = DurableFile::open_to_read(file);
  const std::int64_t size = opened_file.bytes();
  if (size > bytes_max) {
    throw DatabaseError{DatabaseErrorKind::BadInput,
                        file.string() + " is larger than such a file may be; it was not read"};
  }
  std::vector<std::byte> bytes(static_cast<std::size_t>(size));
  bytes.resize(opened_file.read(bytes));
  return bytes;
}

void sync_file(const std::filesystem::path& file) {
  const int descriptor = opened(file, O_RDWR, "write");
  const int answer = ::fsync(descriptor);
  const int error_number = errno;
  ::close(descriptor);
  if (answer != 0) throw file_error(file, "write", error_number);
}

void sync_file_system(const std::filesystem::path& directory) {
  const int descriptor = opened(directory, O_RDONLY | O_DIRECTORY, "read");
  const int answer = ::syncfs(descriptor);
  const int error_number = errno;
  ::close(descriptor);
  if (answer != 0) throw file_error(directory, "write", error_number);
}

DigestedFile digest_of_file(const std::filesystem::path& file) {
  return digested(file, [](std::span<const std::byte>) {});
}

DigestedFile copy_digested(const std::filesystem::path& from, const std::filesystem::path& to) {
  DurableFile written = DurableFile::create(to);
  return digested(from, [&](std::span<const std::byte> piece) { written.write(piece); });
}

}  // namespace hallux::database
