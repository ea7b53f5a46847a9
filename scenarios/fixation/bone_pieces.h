/// The pieces into which planned faces part a bone. Inside this corner only.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "scenarios/faces/reference_face.h"
#include "simulator/mesh/indexed_mesh.h"

namespace hallux::scenarios {

/// A face as a wall.
struct PartingFace {
  ReferenceFace face;
  /// Nothing: the whole plane.
  std::optional<FaceWindow> window;
};

/// The bone in cells of a millimetre, numbered by the piece that they belong to. A face of no
/// thickness lies between cells; where a window ends, cells hang together around it. The hinge of
/// a wedge counts as cut: what turns is a piece of its own.
class BonePieces {
 public:
  /// needs   the mesh is closed
  BonePieces(const simulator::IndexedMesh& outer, std::span<const PartingFace> faces);

  /// Number of the piece at the point; nothing outside of the bone, to half a cell.
  std::optional<std::size_t> at(const Vec3& point_in_bone_mm) const noexcept;
  /// The same, of the nearest cell within 3 mm.
  std::optional<std::size_t> near(const Vec3& point_in_bone_mm) const noexcept;
  /// Of each piece [mm3].
  const std::vector<double>& volumes_mm3() const noexcept { return volumes_mm3_; }

 private:
  using Cell = std::array<std::int64_t, 3>;

  void fill(const simulator::IndexedMesh& outer);
  void part(std::span<const PartingFace> faces);
  double grow(std::size_t seed, std::int32_t number, std::span<const PartingFace> faces);
  Vec3 middle_mm(const Cell& cell) const noexcept;
  Cell cell_of(const Vec3& point_mm) const noexcept;
  Cell cell_at(std::size_t index) const noexcept;
  /// Nothing beyond the grid.
  std::optional<std::size_t> index_of(const Cell& cell) const noexcept;

  Vec3 low_mm_{0.0, 0.0, 0.0};
  Cell size_{0, 0, 0};
  /// Of each cell its piece; see bone_pieces.cpp for what is below 0.
  std::vector<std::int32_t> pieces_;
  std::vector<double> volumes_mm3_;
};

}  // namespace hallux::scenarios
