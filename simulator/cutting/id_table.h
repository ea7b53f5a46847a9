/// Gives the keys that it is shown the numbers 0, 1, 2 ... in the order in which they come: a flat hash table that is
/// asked and never listed, so its inner order reaches no result.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace hallux::simulator {

class IdTable {
 public:
  explicit IdTable(std::size_t keys_expected) {
    std::size_t slots = 16;
    while (slots < 2 * keys_expected) slots *= 2;
    slots_.resize(slots);
  }

  /// The key's number; a key that was never shown gets the next one, and `is_new` says so.
  std::uint32_t id_of(std::uint64_t key, bool& is_new) {
    if (2 * count_ >= slots_.size()) grow();
    Slot& slot = slots_[slot_of(key)];
    is_new = slot.id == empty;
    if (is_new) slot = {key, static_cast<std::uint32_t>(count_++)};
    return slot.id;
  }

 private:
  static constexpr std::uint32_t empty = std::numeric_limits<std::uint32_t>::max();
  struct Slot {
    std::uint64_t key = 0;
    std::uint32_t id = empty;
  };

  /// Knuth's multiplicative hash, then the next free slot.
  std::size_t slot_of(std::uint64_t key) const noexcept {
    const std::uint64_t mixed = (key ^ (key >> 32U)) * 0x9e3779b97f4a7c15U;
    std::size_t slot = static_cast<std::size_t>(mixed >> 20U) & (slots_.size() - 1);
    while (slots_[slot].id != empty && slots_[slot].key != key) {
      slot = (slot + 1) & (slots_.size() - 1);
    }
    return slot;
  }
  void grow() {
    std::vector<Slot> old(2 * slots_.size());
    old.swap(slots_);
    for (const Slot& slot : old) {
      if (slot.id != empty) slots_[slot_of(slot.key)] = slot;
    }
  }

  std::vector<Slot> slots_;
  std::size_t count_ = 0;
};

}  // namespace hallux::simulator
