#include "simulator/base/fixed_array.h"

#include <algorithm>
#include <cstdlib>
#include <new>

namespace hallux {

namespace {

void* taken_or_throw(void* memory) {
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

}  // namespace

void* take_memory(std::size_t bytes) {
  return taken_or_throw(std::malloc(std::max<std::size_t>(bytes, 1)));
}

void* take_zeroed_memory(std::size_t bytes) {
  return taken_or_throw(std::calloc(std::max<std::size_t>(bytes, 1), 1));
}

void free_memory(void* memory) noexcept { std::free(memory); }

}  // namespace hallux
