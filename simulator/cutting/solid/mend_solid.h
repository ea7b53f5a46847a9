/// What a solid that was cut still needs before a half-edge mesh can hold it.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "simulator/cutting/pieces/cut_solid.h"
#include "simulator/cutting/pieces/edge_uses.h"

namespace hallux::simulator {

/// Triangles without area can name the same pair of points twice; half-edge meshes refuse that. Each such edge gets a
/// point of its own in its middle, until no pair is repeated. Keeps its memory for the next time.
class EdgeMender {
 public:
  /// Makes the point in the middle of two points; its index.
  using MiddlePoint = std::function<std::uint32_t(std::uint32_t, std::uint32_t)>;

  /// needs   the surface that the triangles belong to is closed as a chain; pairs are repeated only among the triangles
  ///         from `first_triangle` on, and none of them names a point twice
  void separate(std::vector<Triangle>& triangles, std::vector<FaceOrigin>& origins,
                std::uint32_t first_triangle, const MiddlePoint& middle_of);
  /// The sides of the triangles from `first_triangle` on, as the last call left them.
  const std::vector<EdgeUse>& uses() const noexcept { return uses_; }

 private:
  bool separate_once(std::vector<Triangle>& triangles, std::vector<FaceOrigin>& origins,
                     std::uint32_t first_triangle, const MiddlePoint& middle_of);

  std::vector<EdgeUse> uses_;
  std::vector<std::uint8_t> is_split_;
};

/// The same for the last triangles of a solid.
void separate_repeated_edges(CutSolid& solid, std::uint32_t first_triangle);
/// Leaves out the points that no triangle uses; the others keep their order.
void drop_unused_points(IndexedMesh& mesh);

}  // namespace hallux::simulator
