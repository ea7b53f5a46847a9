/// A file system for SQLite that fails on purpose: a full disk, a read-only one, a broken one.
///
/// Root ignores permissions and nobody wants to fill a real disk, so the failures are made one
/// layer below SQLite.
#pragma once

#include <atomic>

#include "tests/support/forwarding_vfs.h"

namespace hallux::tests {

class FaultyVfs : public ForwardingVfs {
 public:
  using ForwardingVfs::ForwardingVfs;

  /// After `writes` more successful writes, every write answers `sqlite_code` (SQLITE_FULL,
  /// SQLITE_IOERR_WRITE, ...).
  void fail_after(int writes, int sqlite_code) noexcept;
  /// Files are opened read-only although more was asked for, as on a read-only mount.
  void make_read_only(bool is_read_only) noexcept;
  void heal() noexcept;

  int writes_done() const noexcept { return writes_done_.load(); }

  int at_opening(const char* path, int flags) override;
  int at_writing(const char* path, const void* bytes, int count, std::int64_t offset) override;

 private:
  std::atomic<int> writes_left_{-1};
  std::atomic<int> code_{0};
  std::atomic<int> writes_done_{0};
  std::atomic<bool> is_read_only_{false};
};

}  // namespace hallux::tests
