/// A group of `hallux cut` sawn into a bone: each frame as a screen would show it, timed, and then
/// the cut itself. Inside this corner only.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <vector>

#include "simulator/base/progress.h"
#include "simulator/bone/sawn_bone.h"

namespace hallux::ui {

/// One kerf: the plane normal . p = offset in the mesh's millimetres is its middle.
struct CutGroup {
  /// Of any length above 0; the offset is in the same measure.
  Vec3 normal{0.0, 0.0, 1.0};
  double offset = 0.0;
  double kerf_mm = 0.5;
  /// Absent: the cut goes all the way through.
  std::optional<std::filesystem::path> sweep_file;
};

struct GroupOutcome {
  /// From the plane to what the first frame needs, without the tree.
  double contact_ms = 0.0;
  /// One a pose: stamp, outline and patch.
  std::vector<double> frame_ms;
  /// Of the patch, in any frame.
  std::size_t triangles_max = 0;
  std::size_t refused_frames = 0;
  /// See KerfTally; expected 0.
  std::uint32_t nudges = 0;
  /// By this group.
  double removed_mm3 = 0.0;
  /// The group that began the kerf: this one, or an earlier one in the same plane. Nothing where
  /// the plane misses.
  std::optional<std::size_t> kerf;
};

/// A kerf that the kernel would not build a closed solid for: its own fault, nobody's input.
class KernelRefusal : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Saws the next group, one frame a pose; without a sweep all of its plane in one frame.
/// needs   the bone was sawn by nothing else
/// errors  CutInputError for the sweep; KernelRefusal; Cancelled
GroupOutcome saw(simulator::SawnBone& bone, const CutGroup& group, const Progress& progress);

}  // namespace hallux::ui
