/// Fills faces that are known by their directed edges alone: edges become rings, rings become
/// triangles. Inside this room only.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "simulator/cutting/fill/triangulate.h"
#include "simulator/cutting/slice/slab_slice.h"

namespace hallux::simulator {

/// A corner of a face on the lattice of the kerf: place and height.
struct LatticeCorner {
  LatticePoint place;
  std::int64_t height = 0;
};

/// From which side a face is looked at: the two axes that become its plane's right and up; a face
/// counter-clockwise seen from outside must be counter-clockwise in them.
enum class FaceView : std::uint8_t { UV, VU, VZ, ZV, ZU, UZ };

/// The view along the axis on which a face with this normal looks most.
FaceView view_along(const Vec3& normal_in_kerf) noexcept;

class RingFiller {
 public:
  /// Begins a face.
  void begin();
  void add(std::uint32_t from, std::uint32_t to) { edges_.push_back({from, to, no_index, false}); }
  bool is_empty() const noexcept { return edges_.empty(); }

  /// Appends the face's triangles over `corners`.
  /// ensures each added edge is used once in its direction, every other edge as often in one
  ///         direction as in the other; but for edges there and back between two points, which may
  ///         both be left out; no triangle names a point twice
  /// errors  false where the edges do not form rings: nothing may be shown then
  /// thread  any; allocates nothing for single rings once it has seen as large a one
  bool fill(std::span<const LatticeCorner> corners, FaceView view,
            std::vector<Triangle>& triangles);

 private:
  struct Edge {
    std::uint32_t from = 0, to = 0;
    /// Another edge from the same point.
    std::uint32_t next_from = no_index;
    bool is_used = false;
  };

  bool link_rings(std::size_t corner_count);
  bool walk_ring(std::uint32_t first);
  std::uint32_t take_edge_from(std::uint32_t point);
  void fill_single(std::span<const LatticeCorner> corners, FaceView view,
                   std::vector<Triangle>& triangles);
  void fill_several(std::span<const LatticeCorner> corners, FaceView view,
                    std::vector<Triangle>& triangles);
  void name_corners(std::vector<Triangle>& triangles, std::size_t first) const;

  std::vector<Edge> edges_;
  std::vector<std::uint32_t>
      edge_from_;  // per point: an edge that leaves it; all no_index between faces
  std::vector<std::uint32_t> ring_points_;
  std::vector<std::uint32_t> ring_ends_;
  std::vector<LatticePoint> places_;
  std::vector<Loop> loops_;
  Triangulator triangulator_;
};

}  // namespace hallux::simulator
