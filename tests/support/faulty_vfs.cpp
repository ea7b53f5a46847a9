#include "tests/support/faulty_vfs.h"

#include <sqlite3.h>

namespace hallux::tests {

void FaultyVfs::fail_after(int writes, int sqlite_code) noexcept {
  code_ = sqlite_code;
  writes_left_ = writes;
}

int FaultyVfs::at_opening(const char*, int flags) {
  if (!is_read_only_.load() || (flags & SQLITE_OPEN_READWRITE) == 0) return flags;
  return (flags & ~(SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE)) | SQLITE_OPEN_READONLY;
}

void FaultyVfs::make_read_only(bool is_read_only) noexcept { is_read_only_ = is_read_only; }

void FaultyVfs::heal() noexcept {
  writes_left_ = -1;
  is_read_only_ = false;
}

int FaultyVfs::at_writing(const char*, const void*, int, std::int64_t) {
  const int left = writes_left_.load();
  if (left == 0) return code_.load();
  if (left > 0) writes_left_ = left - 1;
  ++writes_done_;
  return SQLITE_OK;
}

}  // namespace hallux::tests
