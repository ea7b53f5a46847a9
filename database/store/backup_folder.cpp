#include "database/store/backup_folder.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <string_view>
#include <system_error>
#include <vector>

#include "database/store/files.h"

namespace hallux::database {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view name_start = "hallux-";

/// Of the folder and of the recordings in it; what cannot be looked at is passed over.
template <typename Work>
void for_each_file(const fs::path& folder, Work&& work) {
  std::error_code error;
  for (fs::directory_iterator entry{folder, error}, end; !error && entry != end;
       entry.increment(error)) {
    work(*entry);
  }
}

/// What is written and removed in it would be elsewhere.
void check_is_no_link(const fs::path& directory) {
  std::error_code ignored;
  if (!fs::is_symlink(fs::symlink_status(directory, ignored))) return;
  throw DatabaseError{
      DatabaseErrorKind::BadInput,
      directory.string() + " is a link, which is not followed; remove it, or name another folder"};
}

}  // namespace

BackupFolder::BackupFolder(fs::path folder, Wait wait) : folder_(std::move(folder)) {
  make_private_directory(folder_);
  check_is_no_link(folder_ / "recordings");
  make_private_directory(folder_ / "recordings");
  const fs::path file = folder_ / ".lock";
  lock_ = ::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0600);
  if (lock_ < 0) throw file_error(file, "make the lock file", errno);
  if (::flock(lock_, wait == Wait::Yes ? LOCK_EX : LOCK_EX | LOCK_NB) != 0) {
    ::close(lock_);
    throw DatabaseError{
        DatabaseErrorKind::Locked,
        "another backup is being written into " + folder_.string() + "; wait until it has ended"};
  }
  clear();
}

BackupFolder::~BackupFolder() {
  clear();
  ::close(lock_);
}

std::string BackupFolder::free_name(const std::string& utc) const {
  const std::string stem = std::string{name_start} + utc.substr(0, 4) + utc.substr(5, 2) +
                           utc.substr(8, 2) + "-" + utc.substr(11, 2) + utc.substr(14, 2) +
                           utc.substr(17, 2);
  std::string name = stem;
  const auto is_taken = [&](const std::string& tried) {
    return fs::exists(folder_ / (tried + ".json")) || fs::exists(folder_ / (tried + ".db"));
  };
  for (int number = 2; is_taken(name); ++number) name = stem + "-" + std::to_string(number);
  return name;
}

std::int64_t BackupFolder::recording_bytes() const {
  std::int64_t bytes = 0;
  for_each_file(folder_ / "recordings", [&](const fs::directory_entry& entry) {
    std::error_code error;
    const std::uintmax_t size = entry.file_size(error);
    if (!error) bytes += static_cast<std::int64_t>(size);
  });
  return bytes;
}

void BackupFolder::check_room(const Database& database, std::int64_t bytes,
                              std::optional<std::uintmax_t> pretended_free_bytes) const {
  std::error_code error;
  const std::uintmax_t there = fs::space(folder_, error).available;
  const std::uintmax_t available = pretended_free_bytes.value_or(error ? 0 : there);
  if (available >= 2 * static_cast<std::uintmax_t>(bytes)) return;
  throw DatabaseError{
      DatabaseErrorKind::Full,
      "no backup of " + database.file().string() + " was made: " + folder_.string() +
          " has less than twice its size free (" + std::to_string(bytes / 1'000'000 + 1) +
          " MB to write); free some space or name another directory"};
}

/// Files that have no final name yet, and tables whose manifest was not written any more.
void BackupFolder::clear() const noexcept {
  const auto is_left = [](const fs::path& file) {
    if (file.filename().string().starts_with(name_start) && file.extension() == ".tables") {
      return !fs::exists(fs::path{file}.replace_extension(".json"));
    }
    return file.string().ends_with(".part") || file.string().ends_with(".part-journal");
  };
  try {
    std::vector<fs::path> left;
    const auto look = [&](const fs::directory_entry& entry) {
      if (is_left(entry.path())) left.push_back(entry.path());
    };
    for_each_file(folder_, look);
    for_each_file(folder_ / "recordings", look);
    std::error_code ignored;
    for (const fs::path& file : left) fs::remove(file, ignored);
  } catch (const std::exception&) {
    return;  // left for the next one
  }
}

std::string moment_in_name(const std::string& stem) {
  constexpr std::size_t digits_at = name_start.size(), length = name_start.size() + 15;
  if (!stem.starts_with(name_start) || stem.size() < length || stem[digits_at + 8] != '-')
    return "";
  std::string digits = stem.substr(digits_at, 8) + stem.substr(digits_at + 9, 6);
  if (digits.find_first_not_of("0123456789") != std::string::npos) return "";
  return digits.substr(0, 4) + "-" + digits.substr(4, 2) + "-" + digits.substr(6, 2) + "T" +
         digits.substr(8, 2) + ":" + digits.substr(10, 2) + ":" + digits.substr(12, 2) + "Z";
}

}  // namespace hallux::database
