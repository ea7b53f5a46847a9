/// Counts what a thread takes from the heap: a program that links this has its operator new
/// replaced.
#pragma once

#include <cstdint>

namespace hallux::tests {

/// How often this thread has called any form of operator new since it began; calls of malloc itself
/// are not seen. thread  any
std::uint64_t allocations_of_this_thread() noexcept;
/// How often it has given memory back. thread  any
std::uint64_t frees_of_this_thread() noexcept;

}  // namespace hallux::tests
