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
  /// Act in turn.
  std::vector<CutGroup> groups;
  /// Made where it is missing, outside the data directory.
  std::filesystem::path output_folder;
  std::filesystem::path data_directory{};
  /// Closes the wedge between two kerfs after all are cut.
  std::optional<HingeGroups> close{};
};

struct WrittenPiece {
  /// Name within the folder.
  std::string file;
  std::size_t triangles = 0;
  double volume_mm3 = 0.0;
  /// As check_closed_solid says of what was written.
  bool is_closed = false;
};

struct HingeReport {
  simulator::HingeOutcome outcome = simulator::HingeOutcome::Stiff;
  double thickness_mm = 0.0;
  /// Where it closed.
  double angle_rad = 0.0;
  std::string wedge_file;
  /// The half beyond the first kerf, and the one beyond the second, which turns; the same where the
  /// bone is undivided.
  std::string fixed_file, moved_file;
};

struct CutReport {
  double input_mm3 = 0.0, removed_mm3 = 0.0, debris_mm3 = 0.0;
  std::size_t debris_pieces = 0;
  /// Largest first.
  std::vector<WrittenPiece> pieces;
  /// One a group.
  std::vector<GroupOutcome> cuts;
  std::optional<HingeReport> hinge;

  /// What the pieces, the debris and what was removed are short of the input [mm3].
  double missing_mm3() const noexcept;
};

/// Reads, cuts, checks, and only then writes piece-1.ply ... (see write_pieces.h).
/// errors  MeshError (CutInputError) for the mesh, the sweeps, and kerfs without a wedge;
///         KernelRefusal; OutputError and DatabaseError where the pieces cannot or may not be
///         written there; Cancelled. After an error no piece is new.
/// thread  any; it is a job: not the render thread
CutReport cut_mesh(const CutRequest& request, const Progress& progress);

}  // namespace hallux::ui
