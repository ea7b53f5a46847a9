/// Writes the pieces of a cut into a folder: all of them or none. Inside this corner only.
#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "simulator/mesh/indexed_mesh.h"

namespace hallux::ui {

/// "piece-1.ply" for index 0.
std::string piece_file(std::size_t index);

/// Writes piece-1.ply ... into a folder of its own within `folder`, and moves them when all are
/// there. A piece-N.ply of an earlier cut with a higher N is removed; one that somebody else made
/// stays, and where a piece has its name nothing is written. `folder` is made where it is missing.
/// errors  OutputError; database::DatabaseError BadInput in the data directory; then no piece is
///         new
void write_pieces(std::span<const simulator::IndexedMesh> meshes,
                  const std::filesystem::path& folder, const std::filesystem::path& data_directory);

}  // namespace hallux::ui
