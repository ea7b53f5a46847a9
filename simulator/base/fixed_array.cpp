#include "simulator/base/fixed_array.h"

#include <sys/mman.h>

#include <algorithm>
#include <cstdlib>
#include <new>

namespace hallux {

namespace {

/// From here on memory comes from the system in whole pages.
constexpr std::size_t large_bytes = 65536;

void* taken_or_throw(void* memory) {
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

}  // namespace

void* take_memory(std::size_t bytes) {
  return taken_or_throw(std::malloc(std::max<std::size_t>(bytes, 1)));
}

void free_memory(void* memory) noexcept { std::free(memory); }

void* take_zeroed_memory(std::size_t bytes) {
  if (bytes < large_bytes) return taken_or_throw(std::calloc(std::max<std::size_t>(bytes, 1), 1));
  void* const memory =
      mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  return taken_or_throw(memory == MAP_FAILED ? nullptr : memory);
}

void free_zeroed_memory(void* memory, std::size_t bytes) noexcept {
  if (memory == nullptr || bytes < large_bytes) {
    std::free(memory);
  } else {
    munmap(memory, bytes);
  }
}

}  // namespace hallux
