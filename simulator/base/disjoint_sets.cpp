#include "simulator/base/disjoint_sets.h"

#include <numeric>

namespace hallux {

DisjointSets::DisjointSets(std::size_t count) : parent_(count) {
  std::iota(parent_.begin(), parent_.end(), 0U);
}

std::uint32_t DisjointSets::root(std::uint32_t member) noexcept {
  while (parent_[member] != member) {
    parent_[member] = parent_[parent_[member]];
    member = parent_[member];
  }
  return member;
}

void DisjointSets::join(std::uint32_t a, std::uint32_t b) noexcept {
  const std::uint32_t root_a = root(a), root_b = root(b);
  if (root_a < root_b) {
    parent_[root_b] = root_a;
  } else {
    parent_[root_a] = root_b;
  }
}

std::vector<std::vector<std::uint32_t>> DisjointSets::groups() {
  std::vector<std::vector<std::uint32_t>> groups;
  std::vector<std::size_t> group_of_root(parent_.size());
  for (std::uint32_t member = 0; member < parent_.size(); ++member) {
    const std::uint32_t own = root(member);
    if (own == member) {
      group_of_root[own] = groups.size();
      groups.emplace_back();
    }
    groups[group_of_root[own]].push_back(member);
  }
  return groups;
}

}  // namespace hallux
