/// One bit for each node of a field, with a rim of clear bits around the grid.
/// Inside this corner only.
#pragma once

#include <algorithm>
#include <cstdint>

#include "simulator/base/fixed_array.h"

namespace hallux::simulator {

class NodeBits {
 public:
  /// Nodes from -1 to beyond the counts, up to whole tiles of 32; all clear.
  NodeBits(std::int32_t u_count, std::int32_t v_count)
      : line_words_(static_cast<std::size_t>(up_to_tiles(v_count) + 1) / 64 + 2),
        words_(line_words_ * static_cast<std::size_t>(up_to_tiles(u_count) + 1)) {}

  void set(std::int32_t u, std::int32_t v) noexcept {
    words_[word_of(u, v)] |= std::uint64_t{1} << bit_of(v);
  }
  void put(std::int32_t u, std::int32_t v, bool is_set) noexcept {
    if (is_set) {
      set(u, v);
    } else {
      words_[word_of(u, v)] &= ~(std::uint64_t{1} << bit_of(v));
    }
  }
  /// Sets the nodes [v_first, v_last) at u.
  void set_span(std::int32_t u, std::int32_t v_first, std::int32_t v_last) noexcept {
    for (std::int32_t v = v_first; v < v_last;) {
      const auto count = std::min(v_last - v, 64 - static_cast<std::int32_t>(bit_of(v)));
      words_[word_of(u, v)] |= ones(count) << bit_of(v);
      v += count;
    }
  }
  /// 64 nodes at u, from v on; bit 0 is node v. u and v from -1; clear beyond the grid.
  std::uint64_t from(std::int32_t u, std::int32_t v) const noexcept {
    const std::size_t word = word_of(u, v);
    const unsigned shift = bit_of(v);
    if (shift == 0) return words_[word];
    return words_[word] >> shift | words_[word + 1] << (64 - shift);
  }
  /// Calls visit(v, missing) for each run of 64 nodes within [v_first, v_last) at u that has clear
  /// bits; `missing` has ones for those, bit 0 is node v.
  template <class Visit>
  void for_missing(std::int32_t u, std::int32_t v_first, std::int32_t v_last, Visit visit) const {
    for (std::int32_t v = v_first; v < v_last; v += 64) {
      const std::uint64_t missing = ~from(u, v) & ones(std::min(v_last - v, 64));
      if (missing != 0) visit(v, missing);
    }
  }

 private:
  static std::int32_t up_to_tiles(std::int32_t count) noexcept { return (count + 32) / 32 * 32; }
  static std::uint64_t ones(std::int32_t count) noexcept {
    return ~std::uint64_t{0} >> (64 - count);
  }
  std::size_t word_of(std::int32_t u, std::int32_t v) const noexcept {
    return static_cast<std::size_t>(u + 1) * line_words_ + static_cast<std::size_t>(v + 1) / 64;
  }
  static unsigned bit_of(std::int32_t v) noexcept { return static_cast<unsigned>(v + 1) % 64; }

  std::size_t line_words_;
  ZeroedArray<std::uint64_t> words_;
};

}  // namespace hallux::simulator
