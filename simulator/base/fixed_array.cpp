#include "simulator/base/fixed_array.h"

#include <new>

namespace hallux {

void* take_memory(std::size_t bytes) { return ::operator new(bytes); }

void free_memory(void* memory) noexcept { ::operator delete(memory); }

}  // namespace hallux
