#include "database/store/files.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>

namespace hallux::database {

namespace {

struct Meaning {
  DatabaseErrorKind kind;
  const char* mend;
};

Meaning meaning_in_data_directory(int error_number) {
  switch (error_number) {
    case ENOSPC:
    case EDQUOT:
    case EFBIG:
      return {DatabaseErrorKind::Full, "the disk is full; free some space"};
    case EROFS:
    case EACCES:
    case EPERM:
      return {DatabaseErrorKind::ReadOnly,
              "it cannot be written; name another directory with --data"};
    case ENOTDIR:
    case EEXIST:
      return {DatabaseErrorKind::ReadOnly,
              "a file is where a directory should be; name another directory with --data"};
    case EISDIR:
      return {DatabaseErrorKind::ReadOnly,
              "a directory is where the file should be; move it away, or name another directory "
              "with --data"};
    case ENOENT:
      return {DatabaseErrorKind::BadInput,
              "a directory of its path is missing; make it, or name another one with --data"};
    case ENAMETOOLONG:
      return {DatabaseErrorKind::BadInput, "the name is too long; give a shorter one with --data"};
    default:
      return {DatabaseErrorKind::InputOutput, "check the disk"};
  }
}

Meaning meaning_where_named(int error_number) {
  using enum DatabaseErrorKind;
  switch (error_number) {
    case ENOSPC:
    case EDQUOT:
    case EFBIG:
      return {Full, "the disk is full; free some space, or name a folder elsewhere"};
    case EROFS:
    case EACCES:
    case EPERM:
      return {ReadOnly, "it is not permitted there; name a folder of your own"};
    case ENOENT:
      return {BadInput, "its folder does not exist; make it, or name another"};
    case EEXIST:
    case ENOTEMPTY:
      return {BadInput, "something has this name already; name another"};
    case ENOTDIR:
      return {BadInput, "a file is where a folder should be; name another"};
    case ELOOP:
      return {BadInput, "it is a link, which is not followed; put the file itself there"};
    case ENAMETOOLONG:
      return {BadInput, "the name is too long; give a shorter one"};
    default:
      return {InputOutput, "check the disk"};
  }
}

DatabaseError error_of(const Meaning& meaning, const std::filesystem::path& file, const char* tried,
                       int error_number) {
  return {meaning.kind, std::string{"could not "} + tried + " " + file.string() + ": " +
                            meaning.mend + " (" +
                            std::error_code{error_number, std::generic_category()}.message() + ")"};
}

}  // namespace

DatabaseError file_error(const std::filesystem::path& file, const char* tried, int error_number) {
  return error_of(meaning_in_data_directory(error_number), file, tried, error_number);
}

DatabaseError named_file_error(const std::filesystem::path& file, const char* tried,
                               int error_number) {
  return error_of(meaning_where_named(error_number), file, tried, error_number);
}

void make_private_directory(const std::filesystem::path& directory) {
  std::error_code error;
  const bool exists = std::filesystem::is_directory(directory, error);
  if (!exists) {
    if (directory.has_parent_path()) {
      std::filesystem::create_directories(directory.parent_path(), error);
      if (error) throw file_error(directory.parent_path(), "make the directory", error.value());
    }
    if (::mkdir(directory.c_str(), 0700) != 0 && errno != EEXIST) {
      throw file_error(directory, "make the directory", errno);
    }
    if (!std::filesystem::is_directory(directory, error)) {
      throw file_error(directory, "make the directory", ENOTDIR);
    }
    return;
  }
  // A directory that already holds other things (a home, /tmp) is not ours to close.
  if (std::filesystem::is_empty(directory, error) && !error) {
    ::chmod(directory.c_str(), 0700);
  }
}

void make_private_file(const std::filesystem::path& file) {
  const int descriptor = ::open(file.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
  if (descriptor >= 0) {
    ::close(descriptor);
    return;
  }
  if (errno != EEXIST) throw file_error(file, "make", errno);
  close_to_others(file);
}

// Not opened: closing it again would drop the POSIX locks of this process's other connections.
void close_to_others(const std::filesystem::path& file) noexcept { ::chmod(file.c_str(), 0600); }

}  // namespace hallux::database
