/// A memory that is full on purpose; replaces operator new in every program that links it.
#pragma once

#include <cstddef>

namespace hallux::tests {

/// While it lives, no other thread than the one that made it gets more than `bytes` at once: what a
/// full memory leaves are crumbs. One at a time.
class FullMemory {
 public:
  explicit FullMemory(std::size_t bytes) noexcept;
  ~FullMemory();
  FullMemory(const FullMemory&) = delete;
  FullMemory& operator=(const FullMemory&) = delete;
};

}  // namespace hallux::tests
