/// Which of many points by which two bodies may meet are asked in every tick: as many as a tick has
/// time for. Inside this corner only.
///
///     points, the foremost first:   o o o o o o | . . . . . . . . .
///                                   in the slots  a few in each tick, in turn
///
/// A further point that is found in the other body takes the slot of the one furthest from it.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

namespace hallux::simulator {

/// Points of one side, and those that are asked in every tick.
inline constexpr std::size_t gripped_point_limit = 256, asked_point_limit = 28;

class AskedPoints {
 public:
  AskedPoints() = default;
  /// Of so many points the foremost have the slots.
  explicit AskedPoints(std::size_t count) noexcept
      : count_(std::min(count, gripped_point_limit)),
        slot_count_(std::min(count_, asked_point_limit)),
        turn_(slot_count_) {
    for (std::size_t i = 0; i < slot_count_; ++i) slots_[i] = i;
  }

  std::span<const std::size_t> slots() const noexcept { return {slots_.data(), slot_count_}; }
  bool has_more() const noexcept { return count_ > slot_count_; }
  /// The point whose turn it is.
  /// needs   has_more()
  std::size_t next() noexcept {
    turn_ = (turn_ + 1) % count_;
    return turn_;
  }

  /// Gives the point the slot of the one furthest away, by the clearances that away(point) says;
  /// the slot, or as many as there are where it has one.
  template <typename Away>
  std::size_t take_in(std::size_t point, const Away& away) noexcept {
    const auto begin = slots_.begin();
    const auto end = begin + static_cast<std::ptrdiff_t>(slot_count_);
    if (std::find(begin, end, point) != end) return slot_count_;
    const auto furthest = std::max_element(
        begin, end, [&](std::size_t a, std::size_t b) { return away(a) < away(b); });
    *furthest = point;
    return static_cast<std::size_t>(furthest - begin);
  }

 private:
  std::array<std::size_t, asked_point_limit> slots_{};
  std::size_t count_ = 0, slot_count_ = 0;
  /// The point that was asked last beside the slots.
  std::size_t turn_ = 0;
};

}  // namespace hallux::simulator
