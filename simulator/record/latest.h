/// The newest value of one thread for one other thread; neither ever waits, older values are
/// overwritten.
///
///     writer: own slot --exchange--> middle --exchange--> own slot of the reader
///
/// Three slots: each side owns one, the third lies in the middle and changes hands by one atomic
/// exchange.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>

namespace hallux::simulator {

template <typename Value>
class Latest {
 public:
  Latest() = default;
  explicit Latest(const Value& first) : slots_{first, first, first} {}

  /// Takes no memory, never waits.
  /// thread  writer
  void write(const Value& value) noexcept {
    slots_[written_] = value;
    written_ = middle_.exchange(written_ | fresh, std::memory_order_acq_rel) & place;
  }

  /// What was written last; the first value where nothing was. Valid until the next call.
  /// thread  reader
  const Value& read() noexcept {
    if ((middle_.load(std::memory_order_relaxed) & fresh) != 0) {
      read_ = middle_.exchange(read_, std::memory_order_acq_rel) & place;
    }
    return slots_[read_];
  }

 private:
  static constexpr std::uint32_t place = 3, fresh = 4;

  std::array<Value, 3> slots_{};
  alignas(64) std::uint32_t written_ = 0;
  alignas(64) std::atomic<std::uint32_t> middle_{1};
  alignas(64) std::uint32_t read_ = 2;
};

}  // namespace hallux::simulator
