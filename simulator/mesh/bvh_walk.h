/// The walk of queries that look for what is nearest, nearer boxes first. Inside this corner only.
#pragma once

#include <algorithm>

#include "simulator/mesh/bvh_tree.h"

namespace hallux::simulator {

/// Visits the slots of leaves whose boxes lie nearer than `limit_mm2`, which the visits may lower;
/// a negative limit ends the walk. `squared_mm2(box)` is at most the squared distance of anything
/// in the box.
template <typename Squared, typename Visit>
void walk_nearer(const std::vector<TreeNode>& nodes, const std::vector<TreeSlot>& slots,
                 double& limit_mm2, const Squared& squared_mm2, const Visit& visit) noexcept {
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
    if (!(top.squared_mm2 <= limit_mm2)) continue;
    const TreeNode& node = nodes[top.node];
    const std::array<double, 2> away{squared_mm2(node.box[0]), squared_mm2(node.box[1])};
    const std::size_t near = away[1] < away[0] ? 1 : 0;
    for (const std::size_t side : {near, 1 - near}) {
      for (std::uint32_t i = 0; i < node.count[side] && away[side] <= limit_mm2; ++i) {
        visit(slots[node.child[side] + i]);
      }
    }
    for (const std::size_t side : {1 - near, near}) {
      if (node.count[side] == 0 && away[side] <= limit_mm2) {
        stack[height++] = {node.child[side], away[side]};
      }
    }
  }
}

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

}  // namespace hallux::simulator
