/// A file system for SQLite that fails on purpose: a full disk, a read-only one, a broken one.
///
/// Root ignores permissions and nobody wants to fill a real disk, so the failures are made one layer below SQLite.
#pragma once

#include <atomic>
#include <memory>
#include <string>

struct sqlite3_vfs;

namespace hallux::tests {

/// Registered with SQLite under its own name for as long as it lives; passes everything on to the default one.
class FaultyVfs {
 public:
  /// needs   no other of that name lives; every connection through it is closed before it goes
  explicit FaultyVfs(std::string name);
  ~FaultyVfs();
  FaultyVfs(const FaultyVfs&) = delete;
  FaultyVfs& operator=(const FaultyVfs&) = delete;

  /// After `writes` more successful writes, every write answers `sqlite_code` (SQLITE_FULL, SQLITE_IOERR_WRITE, ...).
  void fail_after(int writes, int sqlite_code) noexcept;
  /// Files are opened read-only although more was asked for, as on a read-only mount.
  void make_read_only(bool is_read_only) noexcept;
  void heal() noexcept;

  const std::string& name() const noexcept { return name_; }
  int writes_done() const noexcept { return writes_done_.load(); }

  /// For the shim itself: SQLITE_OK, or what this write must answer.
  int answer_to_write() noexcept;
  bool is_read_only() const noexcept { return is_read_only_.load(); }
  sqlite3_vfs* real() const noexcept { return real_; }

 private:
  std::string name_;
  sqlite3_vfs* real_ = nullptr;
  std::unique_ptr<sqlite3_vfs> shim_;
  std::atomic<int> writes_left_{-1};
  std::atomic<int> code_{0};
  std::atomic<int> writes_done_{0};
  std::atomic<bool> is_read_only_{false};
};

}  // namespace hallux::tests
