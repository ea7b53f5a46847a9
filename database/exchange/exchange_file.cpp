/// Every file is opened beneath the folder's own descriptor, never through a link or a pipe, and
/// its size is known before a byte is read: whoever exchanges the folder meanwhile leads nowhere.
/// Lines are cut from one buffer that is digested as it is filled, so a table of any length takes
/// the memory of a few blocks, and is believed only at its end.
#include "database/exchange/exchange_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "database/store/files.h"

namespace hallux::database {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t block_bytes = std::size_t{64} << 10U;

[[noreturn]] void refuse_file(const fs::path& file, const std::string& why) {
  throw DatabaseError{DatabaseErrorKind::BadInput, file.string() + ": " + why};
}

/// Where it is no folder its name is open to: -1 and errno.
int open_folder(const fs::path& folder) {
  return ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
}

/// A regular file of at most so many bytes; its size is known before anything is read.
OwnedDescriptor open_foreign(const ForeignFolder& folder, const std::string& name,
                             std::int64_t bytes_max, std::int64_t& bytes) {
  const fs::path file = folder.path() / name;
  if (!is_exchange_name(name)) refuse_file(folder.path(), "it names a file that no export holds");
  OwnedDescriptor descriptor{
      ::openat(folder.descriptor(), name.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC)};
  if (descriptor.number() < 0) {
    if (errno == ENOENT) refuse_file(file, "is missing; export the attempt again");
    throw named_file_error(file, "read", errno);
  }
  struct stat facts {};
  if (::fstat(descriptor.number(), &facts) != 0) throw named_file_error(file, "read", errno);
  if (!S_ISREG(facts.st_mode)) refuse_file(file, "is no regular file; an export holds only such");
  if (facts.st_size > bytes_max) refuse_file(file, "is larger than such a file can be");
  bytes = facts.st_size;
  return descriptor;
}

}  // namespace

bool is_exchange_name(std::string_view name) noexcept {
  const auto is_letter = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-';
  };
  const std::size_t dot = name.find('.');
  if (dot == 0 || dot == std::string_view::npos || dot + 1 == name.size() || name.size() > 64) {
    return false;
  }
  return std::all_of(name.begin(), name.begin() + static_cast<std::ptrdiff_t>(dot), is_letter) &&
         std::all_of(name.begin() + static_cast<std::ptrdiff_t>(dot) + 1, name.end(), is_letter);
}

OwnedDescriptor::OwnedDescriptor(OwnedDescriptor&& other) noexcept : number_(other.number_) {
  other.number_ = -1;
}

OwnedDescriptor::~OwnedDescriptor() {
  if (number_ >= 0) ::close(number_);
}

ExchangeWriter::ExchangeWriter(const fs::path& folder, std::string name)
    : file_(folder / name),
      descriptor_(
          ::open(file_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0600)) {
  if (descriptor_.number() < 0) throw named_file_error(file_, "write", errno);
  written_.name = std::move(name);
}

void ExchangeWriter::write(std::string_view text) {
  waiting_.append(text);
  if (waiting_.size() >= block_bytes) flush();
}

void ExchangeWriter::flush() {
  std::string_view rest{waiting_};
  digester_.add_bytes(std::as_bytes(std::span{rest.data(), rest.size()}));
  written_.bytes += static_cast<std::int64_t>(rest.size());
  while (!rest.empty()) {
    const ssize_t count = ::write(descriptor_.number(), rest.data(), rest.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) throw named_file_error(file_, "write", errno);
    rest.remove_prefix(static_cast<std::size_t>(count));
  }
  waiting_.clear();
}

ExchangeFile ExchangeWriter::finish() {
  flush();
  if (::fsync(descriptor_.number()) != 0) throw named_file_error(file_, "write", errno);
  written_.digest = digester_.finish();
  return written_;
}

ForeignFolder::ForeignFolder(fs::path folder)
    : folder_(std::move(folder)), descriptor_(open_folder(folder_)) {
  if (descriptor_.number() < 0) throw named_file_error(folder_, "read", errno);
}

bool ForeignFolder::has(const std::string& name) const noexcept {
  struct stat facts {};
  return ::fstatat(descriptor(), name.c_str(), &facts, AT_SYMLINK_NOFOLLOW) == 0;
}

std::string ForeignFolder::read(const std::string& name, std::int64_t bytes_max) const {
  std::int64_t bytes = 0;
  const OwnedDescriptor descriptor = open_foreign(*this, name, bytes_max, bytes);
  std::string content(static_cast<std::size_t>(bytes), '\0');
  std::size_t done = 0;
  while (done < content.size()) {
    const ssize_t count = ::read(descriptor.number(), content.data() + done, content.size() - done);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) throw named_file_error(folder_ / name, "read", errno);
    if (count == 0) refuse_file(folder_ / name, "was cut while it was read");
    done += static_cast<std::size_t>(count);
  }
  return content;
}

ForeignLines::ForeignLines(const ForeignFolder& folder, const ExchangeFile& expected)
    : file_(folder.path() / expected.name),
      expected_(expected),
      descriptor_(open_foreign(folder, expected.name, expected.bytes, bytes_on_disk_)),
      buffer_(block_bytes) {
  if (bytes_on_disk_ != expected_.bytes) {
    refuse_file(file_, "has not the size that the manifest says; it was cut");
  }
}

bool ForeignLines::fill() {
  std::memmove(buffer_.data(), buffer_.data() + first_, last_ - first_);
  last_ -= first_;
  first_ = 0;
  ssize_t count = -1;
  do {
    count = ::read(descriptor_.number(), buffer_.data() + last_, buffer_.size() - last_);
  } while (count < 0 && errno == EINTR);
  if (count < 0) throw named_file_error(file_, "read", errno);
  const auto more = static_cast<std::size_t>(count);
  digester_.add_bytes(std::as_bytes(std::span{buffer_.data() + last_, more}));
  last_ += more;
  bytes_read_ += static_cast<std::int64_t>(more);
  if (bytes_read_ > expected_.bytes) refuse("it grew while it was read");
  return more > 0;
}

bool ForeignLines::next(std::string_view& line) {
  ++line_number_;
  for (std::size_t searched = 0;;) {
    const std::string_view rest{buffer_.data() + first_, last_ - first_};
    const std::size_t end = rest.find('\n', searched);
    if (end != std::string_view::npos) {
      if (end == 0 || rest[end - 1] != '\r') refuse("it is not ended by CR LF");
      line = rest.substr(0, end - 1);
      first_ += end + 1;
      return true;
    }
    if (rest.size() > line_bytes_max) refuse("it is longer than a line can be");
    searched = rest.size();
    if (fill()) continue;
    if (first_ != last_) refuse("the file ends in the middle of it");
    if (bytes_read_ != expected_.bytes || digester_.finish() != expected_.digest) {
      refuse_file(file_, "does not have the digest that the manifest says; it was altered");
    }
    return false;
  }
}

std::string ForeignLines::place() const {
  return file_.string() + ", line " + std::to_string(line_number_);
}

void ForeignLines::refuse(std::string_view why) const {
  throw DatabaseError{DatabaseErrorKind::BadInput, place() + ": " + std::string{why}};
}

}  // namespace hallux::database
