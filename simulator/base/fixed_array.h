/// A fixed number of plain values on the heap, taken once: for state that is too large to lie
/// inside its owner. Inside this room only.
///
/// FixedArray holds values that were written when it was made. ZeroedArray is for state of which
/// little is ever used: all its bits are zero, and the system gives a page of it when the page is
/// first written to.
///
/// The memory is taken in simulator/base, so that the rooms which must never take any during a step
/// can be checked by their symbols: what is constructed there before the first step comes from
/// here.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <type_traits>
#include <utility>

namespace hallux {

/// errors  std::bad_alloc
void* take_memory(std::size_t bytes);
void free_memory(void* memory) noexcept;
/// Of zero bits. Where it is large it is the system's own and nobody wrote to it: the heap would
/// clear, and so touch, what others used before.
/// errors  std::bad_alloc
void* take_zeroed_memory(std::size_t bytes);
/// As many as were taken.
void free_zeroed_memory(void* memory, std::size_t bytes) noexcept;

template <typename Value>
class FixedArray {
  static_assert(std::is_trivially_copyable_v<Value> && std::is_trivially_destructible_v<Value>);

 public:
  explicit FixedArray(std::size_t count, const Value& value = {})
      : values_(static_cast<Value*>(take_memory(count * sizeof(Value)))), count_(count) {
    std::uninitialized_fill_n(values_, count_, value);
  }
  explicit FixedArray(std::span<const Value> values)
      : values_(static_cast<Value*>(take_memory(values.size_bytes()))), count_(values.size()) {
    std::uninitialized_copy(values.begin(), values.end(), values_);
  }
  FixedArray(const FixedArray& other) : FixedArray(std::span<const Value>(other)) {}
  FixedArray& operator=(const FixedArray&) = delete;
  ~FixedArray() { free_memory(values_); }

  std::size_t size() const noexcept { return count_; }
  Value& operator[](std::size_t index) noexcept { return values_[index]; }
  const Value& operator[](std::size_t index) const noexcept { return values_[index]; }
  Value* begin() noexcept { return values_; }
  Value* end() noexcept { return values_ + count_; }
  const Value* begin() const noexcept { return values_; }
  const Value* end() const noexcept { return values_ + count_; }

 private:
  Value* values_;
  std::size_t count_;
};

template <typename Value>
class ZeroedArray {
  static_assert(std::is_trivially_copyable_v<Value> && std::is_trivially_destructible_v<Value>);

 public:
  explicit ZeroedArray(std::size_t count)
      : values_(static_cast<Value*>(take_zeroed_memory(count * sizeof(Value)))), count_(count) {}
  ZeroedArray(const ZeroedArray& other) : ZeroedArray(other.count_) {
    std::uninitialized_copy(other.begin(), other.end(), values_);
  }
  ZeroedArray(ZeroedArray&& other) noexcept
      : values_(std::exchange(other.values_, nullptr)), count_(std::exchange(other.count_, 0)) {}
  ZeroedArray& operator=(ZeroedArray other) noexcept {
    std::swap(values_, other.values_);
    std::swap(count_, other.count_);
    return *this;
  }
  ~ZeroedArray() { free_zeroed_memory(values_, count_ * sizeof(Value)); }

  std::size_t size() const noexcept { return count_; }
  Value& operator[](std::size_t index) noexcept { return values_[index]; }
  const Value& operator[](std::size_t index) const noexcept { return values_[index]; }
  Value* begin() noexcept { return values_; }
  Value* end() noexcept { return values_ + count_; }
  const Value* begin() const noexcept { return values_; }
  const Value* end() const noexcept { return values_ + count_; }

 private:
  Value* values_;
  std::size_t count_;
};

}  // namespace hallux
