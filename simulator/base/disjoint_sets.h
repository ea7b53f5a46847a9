/// Disjoint sets that are joined step by step.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace hallux {

/// Sets of 0 .. count-1; the root of a set is its lowest member.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count);
  std::uint32_t root(std::uint32_t member) noexcept;
  void join(std::uint32_t a, std::uint32_t b) noexcept;
  /// The sets by their lowest members, the members of each ascending.
  std::vector<std::vector<std::uint32_t>> groups();

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace hallux
