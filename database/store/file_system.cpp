#include "database/store/file_system.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <system_error>
#include <vector>

namespace hallux::database {

namespace {

/// Where the log's shared memory is not shared by all who may open the file.
constexpr std::array<std::string_view, 17> network_shares{
    "nfs",   "nfs4",       "cifs",        "smb3",       "smbfs",         "afs",
    "ceph",  "coda",       "gfs2",        "glusterfs",  "lustre",        "ncpfs",
    "ocfs2", "fuse.sshfs", "fuse.rclone", "fuse.davfs", "fuse.glusterfs"};

/// The table writes a blank as \040, and other characters likewise.
std::string without_escapes(std::string_view field) {
  std::string text;
  for (std::size_t i = 0; i < field.size(); ++i) {
    const std::string_view digits = field.substr(std::min(i + 1, field.size()), 3);
    const bool is_escape = field[i] == '\\' && digits.size() == 3 &&
                           digits.find_first_not_of("01234567") == std::string_view::npos;
    if (!is_escape) {
      text.push_back(field[i]);
      continue;
    }
    const int code = (digits[0] - '0') * 64 + (digits[1] - '0') * 8 + (digits[2] - '0');
    text.push_back(static_cast<char>(code));
    i += 3;
  }
  return text;
}

bool lies_below(const std::filesystem::path& path, const std::filesystem::path& mount) {
  const auto mount_end = std::mismatch(mount.begin(), mount.end(), path.begin(), path.end()).first;
  return mount_end == mount.end();
}

}  // namespace

std::string file_system_in(std::string_view mount_table, const std::filesystem::path& path) {
  // 36 35 98:0 /mnt1 /mnt2 rw,noatime master:1 - ext3 /dev/root rw: the fifth, and the first after
  // the dash.
  std::istringstream lines{std::string{mount_table}};
  std::string found;
  std::size_t longest = 0;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words{line};
    const std::vector<std::string> fields{std::istream_iterator<std::string>{words}, {}};
    const auto dash = std::find(fields.begin(), fields.end(), "-");
    if (fields.size() < 5 || dash == fields.end() || dash + 1 == fields.end()) continue;
    const std::filesystem::path mount = without_escapes(fields[4]);
    const std::size_t length = mount.native().size();
    // A later mount on the same place hides the one before.
    if (length < longest || !lies_below(path, mount)) continue;
    longest = length;
    found = *(dash + 1);
  }
  return found;
}

std::string file_system_of(const std::filesystem::path& path) {
  std::error_code error;
  const std::filesystem::path whole = std::filesystem::weakly_canonical(path, error);
  if (error) return "";
  const std::ifstream table{"/proc/self/mountinfo"};
  std::ostringstream text;
  text << table.rdbuf();
  return file_system_in(text.str(), whole);
}

bool is_network_share(std::string_view file_system) noexcept {
  return std::find(network_shares.begin(), network_shares.end(), file_system) !=
         network_shares.end();
}

void check_file_system(const std::filesystem::path& directory, std::string file_system) {
  if (file_system.empty()) file_system = file_system_of(directory);
  if (!is_network_share(file_system)) return;
  throw DatabaseError{DatabaseErrorKind::ReadOnly,
                      "could not open " + (directory / "hallux.db").string() +
                          " for writing: it is on a network share (" + file_system +
                          "), and the database needs memory that all who write share, which two "
                          "machines have not; name a directory on a disk of this machine with "
                          "--data, and bring backups to the share"};
}

}  // namespace hallux::database
