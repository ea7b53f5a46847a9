/// Gives the keys that it is shown the numbers 0, 1, 2 ... in the order in which they come: a flat
/// hash table that is asked and never listed, so its inner order reaches no result.
/// Inside this corner only.
///
/// The slots hold numbers only, and the keys lie in a row in their order: few bytes to clear and to
/// keep near.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace hallux::simulator {

class IdTable {
 public:
  explicit IdTable(std::size_t keys_expected) {
    keys_.reserve(keys_expected);
    make_slots(2 * keys_expected);
  }

  /// The key's number; a key that was never shown gets the next one, and `is_new` says so.
  std::uint32_t id_of(std::uint64_t key, bool& is_new) {
    if (2 * keys_.size() >= slots_.size()) grow();
    std::uint32_t& id = slots_[slot_of(key)];
    is_new = id == empty;
    if (is_new) {
      id = static_cast<std::uint32_t>(keys_.size());
      keys_.push_back(key);
    }
    return id;
  }

 private:
  static constexpr std::uint32_t empty = std::numeric_limits<std::uint32_t>::max();

  /// Knuth's multiplicative hash, then the next free slot. Only the product's highest bits depend
  /// on the whole key, and the second round keeps keys of even steps from crowding: a mesh's edges
  /// go from i to i + 1 or to i + a row.
  std::size_t slot_of(std::uint64_t key) const noexcept {
    constexpr std::uint64_t golden = 0x9e3779b97f4a7c15U;
    const std::uint64_t mixed = key * golden;
    auto slot = static_cast<std::size_t>(((mixed ^ (mixed >> 32U)) * golden) >> shift_);
    while (slots_[slot] != empty && keys_[slots_[slot]] != key) {
      slot = (slot + 1) & (slots_.size() - 1);
    }
    return slot;
  }
  void make_slots(std::size_t least) {
    const std::size_t count = std::bit_ceil(least < 16 ? std::size_t{16} : least);
    slots_.assign(count, empty);
    shift_ = 64 - std::countr_zero(count);
  }
  void grow() {
    make_slots(2 * slots_.size());
    for (std::size_t id = 0; id < keys_.size(); ++id) {
      slots_[slot_of(keys_[id])] = static_cast<std::uint32_t>(id);
    }
  }

  std::vector<std::uint64_t> keys_;   // by number
  std::vector<std::uint32_t> slots_;  // a power of two of numbers
  int shift_ = 0;                     // leaves as many bits as name a slot
};

}  // namespace hallux::simulator
