/// The walk of queries that look for what is nearest, nearer boxes first. Inside this corner only.
#pragma once

#include <algorithm>

#include "simulator/mesh/bvh_tree.h"

namespace hallux::simulator {

inline double squared_distance(const TreeBox& box, const Vec3& point_mm) noexcept {
  double sum = 0.0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double value = point_mm[static_cast<glm::length_t>(axis)];
    const double below = static_cast<double>(box.low[axis]) - value;
    const double above = value - static_cast<double>(box.high[axis]);
    const double outside = std::max(std::max(below, above), 0.0);
    sum += outside * outside;
  }
  return sum;
}

/// Visits the leaves whose boxes are wanted, by the squared distance of the point from the box.
/// wants(squared_mm2)               may want less and less from visit to visit, never more
/// visit(slot, count, squared_mm2)  the leaf's slots, from the first
template <typename Wants, typename Visit>
void walk_nearer(const std::vector<TreeNode>& nodes, const std::vector<TreeSlot>& slots,
                 const Vec3& point_mm, const Wants& wants, const Visit& visit) noexcept {
  struct Waiting {
    std::uint32_t node;
    double squared_mm2;
  };
  if (nodes.empty()) return;
  std::array<Waiting, tree_stack_size> stack;
  stack[0] = {0, 0.0};
  std::size_t height = 1;
  while (height > 0) {
    const Waiting top = stack[--height];
    if (!wants(top.squared_mm2)) continue;
    const TreeNode& node = nodes[top.node];
    const std::array<double, 2> away{squared_distance(node.box[0], point_mm),
                                     squared_distance(node.box[1], point_mm)};
    const std::size_t near = away[1] < away[0] ? 1 : 0;
    for (const std::size_t side : {near, 1 - near}) {
      if (node.count[side] > 0 && wants(away[side])) {
        visit(slots.data() + node.child[side], node.count[side], away[side]);
      }
    }
    for (const std::size_t side : {1 - near, near}) {
      if (node.count[side] == 0 && wants(away[side])) {
        stack[height++] = {node.child[side], away[side]};
      }
    }
  }
}

}  // namespace hallux::simulator
