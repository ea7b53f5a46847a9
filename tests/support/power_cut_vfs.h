/// A file system for SQLite whose power can be cut at any write: what was synced is there
/// afterwards, of all else nobody knows.
///
///     write ----> real file, which this process goes on reading
///           \---> kept apart: what was durable at the last sync, and each write since
///     power cut: a copy of each file, durable bytes and then every unsynced write whole, torn or
///     not at all
///
/// A disk may reorder what was not synced, so each write is decided by itself; a torn one keeps
/// some of its sectors. The shared memory of the log is not on the disk and is gone. That a disk
/// keeps what it said it had synced is taken for granted.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "tests/support/forwarding_vfs.h"

namespace hallux::tests {

class PowerCutVfs : public ForwardingVfs {
 public:
  using ForwardingVfs::ForwardingVfs;

  /// Called before each write and each sync; may cut the power.
  /// thread  the one that writes
  std::function<void()> before_write;

  /// Leaves in `directory` what the disk might hold if the power went now. The seed decides about
  /// what was not synced.
  void leave_after_power_cut(const std::filesystem::path& directory, std::uint64_t seed);

  struct Change {
    std::int64_t offset = 0;
    /// Empty: the file was cut to `offset`.
    std::vector<std::uint8_t> bytes;
  };

  /// Takes the file as it is as durable, where it is new here.
  int at_opening(const char* path, int flags) override;
  int at_writing(const char* path, const void* bytes, int count, std::int64_t offset) override;
  void at_truncating(const char* path, std::int64_t size) override;
  bool at_syncing(const char* path) override;
  void at_removing(const char* path) override;
  /// Nothing is promised: no atomic write, no order of appends, no sector that survives beside a
  /// written one.
  int sector_bytes(int real) const override;
  int characteristics(int real) const override;

 private:
  struct File {
    std::vector<std::uint8_t> durable;
    std::vector<Change> unsynced;
  };
  void note(const char* path, Change change);

  std::mutex mutex_;
  std::map<std::string, File> files_;
};

}  // namespace hallux::tests
