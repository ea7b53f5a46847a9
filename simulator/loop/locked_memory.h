/// Whether the system keeps this program's memory in place while somebody operates.
/// Inside this corner only.
#pragma once

#include <sys/resource.h>

namespace hallux::simulator {

/// While it lives, no page that the program has touched is taken from it, so no tick waits for a
/// disk. Only what exists is locked: the haptic thread takes all its memory before. Asked for only
/// where the limit of locked memory can be lifted (RLIMIT_MEMLOCK; `@haptics - memlock unlimited`):
/// under a small one a locked stack that grows would end the program.
/// thread  the same for making and destroying; one at a time in a program
class LockedMemory {
 public:
  LockedMemory() noexcept;
  ~LockedMemory();
  LockedMemory(const LockedMemory&) = delete;
  LockedMemory& operator=(const LockedMemory&) = delete;

  bool is_granted() const noexcept { return is_granted_; }

 private:
  rlimit before_{};
  bool is_granted_ = false;
};

}  // namespace hallux::simulator
