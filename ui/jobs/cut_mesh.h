/// Cuts any closed mesh by planes and writes the pieces: what `hallux cut` does.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "assessment/progress.h"
#include "simulator/base/vector.h"
#include "ui/jobs/cut_sweep.h"

namespace hallux::ui {

/// One kerf: the plane normal . p = offset in the mesh's millimetres is its middle.
struct CutGroup {
  Vec3 normal{0.0, 0.0, 1.0};  ///< of any length above 0; the offset is in the same measure
  double offset = 0.0;
  double kerf_mm = 0.5;
  std::optional<std::filesystem::path> sweep_file;  ///< absent: the cut goes all the way through
};

struct CutRequest {
  std::filesystem::path mesh_file;
  std::vector<CutGroup> groups;         ///< act in turn
  std::filesystem::path output_folder;  ///< made where it is missing
};

struct WrittenPiece {
  std::string file;  ///< name within the folder
  std::size_t triangles = 0;
  double volume_mm3 = 0.0;
  bool is_closed = false;  ///< as check_closed_solid says of what was written
};

struct GroupOutcome {
  double contact_ms = 0.0;  ///< slicing and clipping, without building the search tree
  double removed_mm3 = 0.0;
};

struct CutReport {
  double input_mm3 = 0.0, removed_mm3 = 0.0, debris_mm3 = 0.0;
  std::size_t debris_pieces = 0;
  std::size_t triangles_max = 0;
  std::vector<WrittenPiece> pieces;  ///< largest first
  std::vector<GroupOutcome> cuts;
};

/// Reads, cuts, checks, and only then writes piece-1.ply ... into a folder of its own, and moves them when all are there.
/// A piece-N.ply of an earlier cut with a higher N is removed.
/// errors  MeshError (CutInputError) for the mesh and the sweeps; DatabaseError where the folder cannot be written (BadInput: made);
///         Cancelled. After an error no piece is new.
/// thread  any; it is a job: not the render thread
CutReport cut_mesh(const CutRequest& request, const assessment::Progress& progress);

}  // namespace hallux::ui
