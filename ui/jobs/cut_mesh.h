/// Cuts any closed mesh by planes and writes the pieces: what `hallux cut` does.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "simulator/base/progress.h"
#include "simulator/cutting/hinge/hinge.h"
#include "ui/jobs/kerf_frames.h"

namespace hallux::ui {

/// Two groups, by index, whose kerfs meet at a bridge of bone.
struct HingeGroups {
  std::size_t first = 0, second = 1;
};

struct CutRequest {
  std::filesystem::path mesh_file;
  std::vector<CutGroup> groups;         ///< act in turn
  std::filesystem::path output_folder;  ///< made where it is missing
  std::optional<HingeGroups> close{};   ///< closes the wedge between two kerfs after all are cut
};

struct WrittenPiece {
  std::string file;  ///< name within the folder
  std::size_t triangles = 0;
  double volume_mm3 = 0.0;
  bool is_closed = false;  ///< as check_closed_solid says of what was written
};

struct HingeReport {
  simulator::HingeOutcome outcome = simulator::HingeOutcome::Stiff;
  double thickness_mm = 0.0;
  double angle_rad = 0.0;  ///< where it closed
  std::string wedge_file;
  /// The half beyond the first kerf, and the one beyond the second, which turns; the same where the bone is undivided.
  std::string fixed_file, moved_file;
};

struct CutReport {
  double input_mm3 = 0.0, removed_mm3 = 0.0, debris_mm3 = 0.0;
  std::size_t debris_pieces = 0;
  std::vector<WrittenPiece> pieces;  ///< largest first
  std::vector<GroupOutcome> cuts;    ///< one a group
  std::optional<HingeReport> hinge;

  /// What the pieces, the debris and what was removed are short of the input [mm3].
  double missing_mm3() const noexcept;
};

/// Reads, cuts, checks, and only then writes piece-1.ply ... (see write_pieces.h).
/// errors  MeshError (CutInputError) for the mesh, the sweeps, and kerfs without a wedge; KernelRefusal; OutputError where
///         the folder cannot be made or written; Cancelled. After an error no piece is new.
/// thread  any; it is a job: not the render thread
CutReport cut_mesh(const CutRequest& request, const Progress& progress);

}  // namespace hallux::ui
