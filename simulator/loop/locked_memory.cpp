#include "simulator/loop/locked_memory.h"

#include <sys/mman.h>

namespace hallux::simulator {

LockedMemory::LockedMemory() noexcept {
  if (::getrlimit(RLIMIT_MEMLOCK, &before_) != 0) return;
  const rlimit none{RLIM_INFINITY, RLIM_INFINITY};
  if (::setrlimit(RLIMIT_MEMLOCK, &none) != 0) return;
  // On fault: the untouched rest of every stack and library is not fetched for it.
  is_granted_ = ::mlockall(MCL_CURRENT | MCL_ONFAULT) == 0;
  if (!is_granted_) ::setrlimit(RLIMIT_MEMLOCK, &before_);
}

LockedMemory::~LockedMemory() {
  if (!is_granted_) return;
  ::munlockall();
  ::setrlimit(RLIMIT_MEMLOCK, &before_);
}

}  // namespace hallux::simulator
