#include "ui/app/terminal/freed_memory.h"

#include <malloc.h>

namespace hallux::ui {

namespace {

/// Blocks from `large_block_bytes` on are the system's own, and go back to it when they are freed.
/// So much as `kept_bytes` each thread's heap keeps at its end for what is asked for next.
void hold_heaps(int large_block_bytes, int kept_bytes) noexcept {
  ::mallopt(M_MMAP_THRESHOLD, large_block_bytes);
  ::mallopt(M_TRIM_THRESHOLD, kept_bytes);
}

}  // namespace

void keep_freed_memory() noexcept { hold_heaps(32 << 20, 32 << 20); }

void give_freed_memory_back() noexcept { hold_heaps(1 << 17, 8 << 20); }

}  // namespace hallux::ui
