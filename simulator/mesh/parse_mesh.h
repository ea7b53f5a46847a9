/// The three formats behind parse_mesh. Inside this corner only.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "simulator/mesh/read_mesh.h"

namespace hallux::simulator {

/// What every reader is told.
struct MeshSource {
  std::span<const std::byte> bytes;
  std::string_view name;
  MeshLimits limits;

  std::string_view text() const noexcept {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
  }
};

/// errors  MeshError, as parse_mesh
IndexedMesh parse_stl(const MeshSource& source);
IndexedMesh parse_obj(const MeshSource& source);
IndexedMesh parse_ply(const MeshSource& source);

/// Makes one point of corners with equal coordinates, in order of first appearance; leaves out
/// triangles of which two corners are equal, because they have no area and their edges cancel.
IndexedMesh weld_corners(const std::vector<Vec3>& corners_mm);

/// errors  MeshError where `count` triangles (or points) are more than the limits allow
void check_triangle_count(const MeshSource& source, std::size_t count);
void check_point_count(const MeshSource& source, std::size_t count);

}  // namespace hallux::simulator
