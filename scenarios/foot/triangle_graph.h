/// A closed triangle mesh that can be rebuilt edge by edge: split, collapse, flip.
///
/// Side h = 3 t + k runs from corner k of triangle t to the next corner; `twin` is the same edge seen from the
/// neighbour. The mesh is closed, so every side has a twin and every walk around a point comes back.
#pragma once

#include <cstdint>
#include <vector>

#include "simulator/mesh/indexed_mesh.h"

namespace hallux::scenarios {

using Side = std::uint32_t;
using PointIndex = std::uint32_t;

class TriangleGraph {
 public:
  /// errors  ScenarioError where the mesh is not closed
  explicit TriangleGraph(const simulator::IndexedMesh& mesh);

  Side side_count() const noexcept { return static_cast<Side>(start_.size()); }
  PointIndex point_count() const noexcept { return static_cast<PointIndex>(points_mm_.size()); }
  bool is_side(Side h) const noexcept { return start_[h] != dead; }
  bool is_point(PointIndex p) const noexcept { return leaving_[p] != dead; }
  PointIndex start(Side h) const noexcept { return start_[h]; }
  PointIndex end(Side h) const noexcept { return start_[next(h)]; }
  PointIndex apex(Side h) const noexcept { return start_[previous(h)]; }
  Side twin(Side h) const noexcept { return twin_[h]; }
  std::uint32_t valence(PointIndex p) const noexcept { return valence_[p]; }
  const Vec3& at(PointIndex p) const noexcept { return points_mm_[p]; }
  void move(PointIndex p, const Vec3& to_mm) noexcept { points_mm_[p] = to_mm; }

  static Side next(Side h) noexcept { return h % 3 == 2 ? h - 2 : h + 1; }
  static Side previous(Side h) noexcept { return h % 3 == 0 ? h + 2 : h - 1; }

  /// Calls visit(h) for each side that leaves the point, against the clock seen from outside.
  template <class Visit>
  void for_each_leaving(PointIndex p, Visit visit) const {
    const Side first = leaving_[p];
    Side h = first;
    do {
      visit(h);
      h = twin_[previous(h)];
    } while (h != first);
  }

  bool are_neighbours(PointIndex a, PointIndex b) const noexcept;
  /// Twice the area times the outward normal of the triangle the side belongs to.
  Vec3 area_vector(Side h) const noexcept;

  /// Puts a point on the edge and divides its two triangles.
  PointIndex split(Side h, const Vec3& point_mm);
  /// Whether collapsing the edge keeps the surface a surface (link condition).
  bool can_collapse(Side h) const noexcept;
  /// Merges the edge's end into its start, which moves to `point_mm`; its two triangles vanish.
  /// needs   can_collapse(h)
  void collapse(Side h, const Vec3& point_mm);
  /// Whether the edge may turn to join its two apexes.
  bool can_flip(Side h) const noexcept;
  /// needs   can_flip(h)
  void flip(Side h);

  /// What lives, numbered again in order.
  simulator::IndexedMesh indexed() const;

 private:
  static constexpr std::uint32_t dead = 0xffffffffU;

  void pair(Side a, Side b) noexcept;
  void set_triangle(Side first, PointIndex a, PointIndex b, PointIndex c) noexcept;

  std::vector<Vec3> points_mm_;
  std::vector<PointIndex> start_;
  std::vector<Side> twin_;
  std::vector<Side> leaving_;  ///< one side that starts at each point
  std::vector<std::uint32_t> valence_;
};

}  // namespace hallux::scenarios
