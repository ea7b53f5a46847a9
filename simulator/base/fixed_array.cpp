#include "simulator/base/fixed_array.h"

#include <new>

namespace hallux {

void* take_memory(std::size_t bytes) { return ::operator new(bytes); }

void give_memory_back(void* memory) noexcept { ::operator delete(memory); }

}  // namespace hallux
