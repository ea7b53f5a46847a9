/// A short list with room inside itself. Inside this room only.
#pragma once

#include <array>
#include <cstddef>

#include "simulator/base/check.h"

namespace hallux {

template <typename Value, std::size_t Capacity>
class FixedList {
 public:
  bool is_full() const noexcept { return count_ == Capacity; }
  std::size_t size() const noexcept { return count_; }
  /// needs   not is_full()
  void push(const Value& value) noexcept {
    CHECK(count_ < Capacity);
    values_[count_++] = value;
  }
  const Value* begin() const noexcept { return values_.data(); }
  const Value* end() const noexcept { return values_.data() + count_; }

 private:
  std::array<Value, Capacity> values_{};
  std::size_t count_ = 0;
};

}  // namespace hallux
