#include "tests/ui/screens/operating/full_memory.h"

#include <atomic>
#include <cstdlib>
#include <limits>
#include <new>

namespace {

constexpr std::size_t no_limit = std::numeric_limits<std::size_t>::max();
std::atomic<std::size_t> most_bytes{no_limit};
thread_local bool is_spared = false;

void* take(std::size_t bytes) noexcept {
  const bool is_allowed = is_spared || bytes <= most_bytes.load(std::memory_order_relaxed);
  return is_allowed ? std::malloc(bytes > 0 ? bytes : 1) : nullptr;
}

}  // namespace

namespace hallux::tests {

FullMemory::FullMemory(std::size_t bytes) noexcept {
  is_spared = true;
  most_bytes.store(bytes);
}

FullMemory::~FullMemory() { most_bytes.store(no_limit); }

}  // namespace hallux::tests

void* operator new(std::size_t bytes) {
  void* place = take(bytes);
  if (place == nullptr) throw std::bad_alloc();
  return place;
}
// Also what algorithms ask for without throwing: all of it is freed in one way.
void* operator new(std::size_t bytes, const std::nothrow_t&) noexcept { return take(bytes); }
void operator delete(void* place) noexcept { std::free(place); }
void operator delete(void* place, std::size_t) noexcept { std::free(place); }
void operator delete(void* place, const std::nothrow_t&) noexcept { std::free(place); }
