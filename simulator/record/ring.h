/// A bounded ring between one producer thread and one consumer thread; neither ever waits for the
/// other's lock. Inside this room only.
///
/// Positions only grow; the slot is position modulo capacity. The producer publishes with a release
/// store of `head_`, the consumer frees with a release store of `tail_`; each keeps the other's
/// last seen position to touch the shared cache line rarely.
#pragma once

#include <atomic>
#include <cstddef>
#include <vector>

namespace hallux::simulator {

template <typename Value>
class Ring {
 public:
  /// needs   capacity > 0; all memory is taken here
  explicit Ring(std::size_t capacity) : slots_(capacity) {}

  /// False where the ring is full. Takes no memory, never waits.
  /// thread  producer
  bool push(const Value& value) noexcept {
    const std::size_t head = head_.load(std::memory_order_relaxed);
    if (head - tail_seen_ == slots_.size()) {
      tail_seen_ = tail_.load(std::memory_order_acquire);
      if (head - tail_seen_ == slots_.size()) return false;
    }
    slots_[head % slots_.size()] = value;
    head_.store(head + 1, std::memory_order_release);
    return true;
  }

  /// False where the ring is empty.
  /// thread  consumer
  bool pop(Value& value) noexcept {
    const std::size_t tail = tail_.load(std::memory_order_relaxed);
    if (tail == head_seen_) {
      head_seen_ = head_.load(std::memory_order_acquire);
      if (tail == head_seen_) return false;
    }
    value = slots_[tail % slots_.size()];
    tail_.store(tail + 1, std::memory_order_release);
    return true;
  }

  /// Values waiting, as one of the two threads sees it now.
  std::size_t size() const noexcept {
    const std::size_t tail = tail_.load(std::memory_order_acquire);
    const std::size_t head = head_.load(std::memory_order_acquire);
    return head >= tail ? head - tail : 0;
  }
  std::size_t capacity() const noexcept { return slots_.size(); }

 private:
  std::vector<Value> slots_;
  alignas(64) std::atomic<std::size_t> head_{0};
  std::size_t tail_seen_ = 0;
  alignas(64) std::atomic<std::size_t> tail_{0};
  std::size_t head_seen_ = 0;
};

}  // namespace hallux::simulator
