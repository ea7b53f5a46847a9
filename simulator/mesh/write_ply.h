/// Writes PLY: binary little-endian, indexed, double coordinates in millimetres.
#pragma once

#include <filesystem>
#include <string>

#include "simulator/mesh/indexed_mesh.h"

namespace hallux::simulator {

/// The file's bytes.
std::string ply_bytes(const IndexedMesh& mesh);
/// Writes beside the target, then renames: the target is the old file or the whole new one.
/// errors  MeshError naming the file and the reason (no room, no permission)
void write_ply(const IndexedMesh& mesh, const std::filesystem::path& file);

}  // namespace hallux::simulator
