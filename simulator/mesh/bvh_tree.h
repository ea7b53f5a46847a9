/// The tree inside Bvh: its memory and how it is built. Inside this corner only.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "simulator/mesh/bvh.h"
#include "simulator/mesh/surface_normals.h"

namespace hallux::simulator {

/// An axis-aligned box in single precision, rounded outward: it holds what it was made around.
struct TreeBox {
  std::array<float, 3> low{};
  std::array<float, 3> high{};
};

/// Two boxes side by side, so that one visit decides about both children.
struct TreeNode {
  std::array<TreeBox, 2> box;
  /// Node; or first slot where count > 0.
  std::array<std::uint32_t, 2> child{};
  /// Slots of a leaf.
  std::array<std::uint32_t, 2> count{};
};

/// The corners of one triangle in the order of the leaves.
struct TreeSlot {
  std::array<Vec3, 3> corner_mm;
  std::uint32_t triangle = 0;
  /// Too thin for a plane of its own.
  bool is_sliver = false;
};

/// A stack of this many nodes is enough for any tree that build_tree makes.
inline constexpr std::size_t tree_stack_size = 80;

struct Bvh::Tree {
  /// The first is the root; empty for an empty mesh.
  std::vector<TreeNode> nodes;
  std::vector<TreeSlot> slots;
  SurfaceNormals normals;
};

/// Fills nodes and slots.
void build_nodes(const IndexedMesh& mesh, const BvhBuild& build, std::vector<TreeNode>& nodes,
                 std::vector<TreeSlot>& slots);

}  // namespace hallux::simulator
