/// Reads STL (binary and text), OBJ and PLY (text and binary) from files that nobody vouches for.
///
/// Every count is compared with the bytes that are there before memory is taken, and with
/// MeshLimits.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string_view>

#include "simulator/mesh/indexed_mesh.h"
#include "simulator/mesh/mesh_error.h"

namespace hallux::simulator {

struct MeshLimits {
  std::size_t bytes = std::size_t{512} << 20U;
  std::size_t triangles = 5'000'000;
  std::size_t points = 5'000'000;
};

/// A coordinate beyond this is no bone in millimetres, and products of such numbers could overflow.
inline constexpr double largest_coordinate_mm = 1.0e6;

enum class MeshFormat { Stl, Obj, Ply };

/// The mesh in the file, in the file's own units taken as millimetres; STL corners with equal
/// coordinates become one point and STL triangles that thereby lose a corner are left out; points
/// that no triangle uses are left out.
/// ensures the mesh is closed, manifold and outward (see check_closed_solid), and no part of space
///         lies in it twice (see check_shells)
/// errors  MeshError naming the file, the place and the mend
IndexedMesh read_mesh(const std::filesystem::path& file, const MeshLimits& limits = {});

/// The same from bytes in memory; `name` stands in the messages. Does not check that the mesh is
/// closed.
IndexedMesh parse_mesh(std::span<const std::byte> bytes, MeshFormat format, std::string_view name,
                       const MeshLimits& limits = {});

/// errors  MeshError unless each directed edge occurs once with its opposite, all coordinates are
///         finite and within largest_coordinate_mm, there is at least one triangle without a corner
///         twice, and the enclosed volume is positive; the sentence counts the faults and places
///         the first
void check_closed_solid(const IndexedMesh& mesh, std::string_view name);

/// errors  MeshError naming the place where two shells cross, or where one does not face the other
///         way than the one that it lies in: a marrow canal in a bone faces inward
/// needs   a mesh that passed check_closed_solid
void check_shells(const IndexedMesh& mesh, std::string_view name);

}  // namespace hallux::simulator
