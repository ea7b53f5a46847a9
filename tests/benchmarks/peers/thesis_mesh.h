/// The method of the thesis that began this project, written once, to be measured beside ours.
///
/// At first touch the mesh is sliced by one plane along the ring of triangles that can be walked to
/// from the touched one; no volume is lost, and both sides are closed by a fan of triangles around
/// the middle of their corners. Each crossing is a pair of points at one place, one per side; the
/// blade parts the pairs it passes over by half a kerf each. Source: thesis 4.4.3 (single plane),
/// 4.5.1 to 4.5.4 (split, caps, walk), 4.6 (parting, disjoint parts), 5.3 (spare room). Its octree
/// is not built: the touched triangle is given, found by our tree.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "simulator/cutting/field/kerf.h"
#include "simulator/mesh/indexed_mesh.h"

namespace hallux::benchmarks {

class ThesisMesh {
 public:
  /// Finds each triangle's neighbours, and takes a fifth more memory than the mesh needs.
  /// needs   the mesh is closed and oriented, its edges join two triangles each
  explicit ThesisMesh(simulator::IndexedMesh mesh);

  /// Slices along the ring of each touched triangle; false where the plane crosses none of them.
  bool begin_cut(const simulator::KerfPlane& plane, std::span<const std::uint32_t> touched);
  /// Parts the pairs that lie under the blade; how many they were.
  std::size_t advance(const simulator::Blade& blade, const simulator::PlanarPose& pose);
  /// How many parts hang together, found by a walk over the whole mesh.
  std::size_t count_parts() const;
  /// Triangles of this cut that the parting has turned over: the folds of thesis 4.4.5.
  std::size_t folded_triangles() const;

  const simulator::IndexedMesh& mesh() const noexcept { return mesh_; }
  std::size_t pair_count() const noexcept { return pairs_.size(); }
  bool is_parted() const noexcept { return parted_ == pairs_.size(); }

 private:
  /// Two points at one place: `above` on the side of the plane's normal, `above` + 1 below it.
  struct Pair {
    std::uint32_t above = 0;
    Vec2 place_mm{0.0, 0.0};
    bool is_parted = false;
  };

  bool is_above(std::uint32_t point) const;
  bool crosses(std::uint32_t triangle) const;
  std::vector<std::uint32_t> walk_ring(std::uint32_t touched_triangle);
  std::uint32_t add_pair(const Vec3& point_mm);
  std::uint32_t pair_on(std::uint32_t point_a, std::uint32_t point_b);
  void split(std::uint32_t triangle, std::vector<std::uint32_t>& made);
  void slice_ring(std::uint32_t touched_triangle, std::vector<std::uint32_t>& made);
  void add_caps(std::size_t first_pair, std::size_t first_segment);
  void link(const std::vector<std::uint32_t>& made);
  std::uint32_t add_triangle(const simulator::Triangle& corners);
  void pass_on_neighbour(std::uint32_t from, std::uint32_t edge, std::uint32_t to,
                         std::uint32_t new_edge);

  simulator::IndexedMesh mesh_;
  /// Across the edge behind each corner.
  std::vector<std::array<std::uint32_t, 3>> neighbours_;
  /// The number of the cut that came here.
  std::vector<std::uint32_t> visited_;
  std::uint32_t cut_ = 0;

  simulator::KerfPlane plane_;
  Vec3 normal_{0.0, 0.0, 1.0};
  double offset_mm_ = 0.0;
  RigidTransform kerf_from_bone_;
  std::vector<Pair> pairs_;
  std::size_t parted_ = 0;
  /// Edge to its pair's `above`.
  std::unordered_map<std::uint64_t, std::uint32_t> pair_on_edge_;
  /// Of the section, by `above`, bone on its left.
  std::vector<std::array<std::uint32_t, 2>> segments_;
};

}  // namespace hallux::benchmarks
