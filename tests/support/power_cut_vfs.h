/// A file system for SQLite whose power can be cut at any write: what was synced is there afterwards, of all else nobody knows.
///
///     write ----> real file, which this process goes on reading
///           \---> kept apart: what was durable at the last sync, and each write since
///     power cut: a copy of each file, durable bytes and then every unsynced write whole, torn or not at all
///
/// A disk may reorder what was not synced, so each write is decided by itself; a torn one keeps some of its sectors. The shared
/// memory of the log is not on the disk and is gone. That a disk keeps what it said it had synced is taken for granted.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

struct sqlite3_vfs;

namespace hallux::tests {

class PowerCutVfs {
 public:
  /// needs   no other of that name lives; every connection through it is closed before it goes
  explicit PowerCutVfs(std::string name);
  ~PowerCutVfs();
  PowerCutVfs(const PowerCutVfs&) = delete;
  PowerCutVfs& operator=(const PowerCutVfs&) = delete;

  const std::string& name() const noexcept { return name_; }

  /// Called before each write and each sync; may cut the power.
  /// thread  the one that writes
  std::function<void()> before_write;

  /// Leaves in `directory` what the disk might hold if the power went now. The seed decides about what was not synced.
  void leave_after_power_cut(const std::filesystem::path& directory, std::uint64_t seed);

  // -- for the shim itself
  struct Change {
    std::int64_t offset = 0;
    std::vector<std::uint8_t> bytes;  ///< empty: the file was cut to `offset`
  };
  /// Takes the file as it is as durable, where it is new here.
  void know(const std::string& path);
  void note(const std::string& path, Change change);
  void note_sync(const std::string& path);
  void note_removal(const std::string& path);
  sqlite3_vfs* real() const noexcept { return real_; }

 private:
  struct File {
    std::vector<std::uint8_t> durable;
    std::vector<Change> unsynced;
  };

  std::string name_;
  sqlite3_vfs* real_ = nullptr;
  std::unique_ptr<sqlite3_vfs> shim_;
  std::mutex mutex_;
  std::map<std::string, File> files_;
};

}  // namespace hallux::tests
