/// One kerf being sawn, frame by frame as a screen would show it, and then committed.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <vector>

#include "simulator/base/progress.h"
#include "simulator/cutting/solid/commit_patch.h"
#include "ui/jobs/cut_sweep.h"

namespace hallux::ui {

struct OpenedKerf {
  std::size_t number = 0;  ///< of the group that began it; what FaceOrigin::kerf says
  simulator::KerfPlane plane;
  simulator::FieldGrid grid;                  ///< around the uncut bone's section
  std::optional<simulator::KerfField> field;  ///< absent: all the way through
  simulator::RegionOutline region;
  double removed_mm3 = 0.0;  ///< of the solid that earlier kerfs had left
};

struct GroupOutcome {
  double contact_ms = 0.0;       ///< from the plane to what the first frame needs, without the tree
  std::vector<double> frame_ms;  ///< one a pose: stamp, outline and patch
  std::size_t triangles_max = 0;  ///< of the patch, in any frame
  std::size_t refused_frames = 0;
  std::uint32_t nudges = 0;  ///< see KerfCut; expected 0
  double removed_mm3 = 0.0;  ///< by this group
  /// The group that began the kerf: this one, or an earlier one in the same plane. Nothing where the plane misses.
  std::optional<std::size_t> kerf;
};

/// A kerf that the kernel would not build a closed solid for: its own fault, nobody's input.
class KernelRefusal : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

class KerfFrames {
 public:
  /// Slices the contact. Borrows all three.
  /// needs   solid has triangles
  KerfFrames(const simulator::CutSolid& solid, OpenedKerf& kerf, GroupOutcome& outcome);
  KerfFrames(const KerfFrames&) = delete;
  KerfFrames& operator=(const KerfFrames&) = delete;

  /// One frame a pose: stamp, outline, patch.
  /// needs   kerf.field
  /// errors  Cancelled
  void follow(const BladePath& path, const Progress& progress);
  /// One frame in which all of the section goes; the kerf is through from then on.
  void open_all();
  /// What is left. A last frame that was refused is built again beside it (see cut_kerf).
  /// errors  KernelRefusal where that does not help
  simulator::KerfCut commit();

 private:
  using Clock = std::chrono::steady_clock;

  void build(const simulator::RegionOutline& region);

  const simulator::CutSolid& solid_;
  OpenedKerf& kerf_;
  GroupOutcome& outcome_;
  simulator::Bvh bvh_;
  Clock::time_point start_;
  simulator::KerfContact contact_;
  simulator::PatchBuilder builder_;
  simulator::SolidPatch patch_;
  bool is_refused_ = false;  ///< the last frame
};

/// The kerf's region taken out of a solid.
/// errors  KernelRefusal
simulator::KerfCut cut_opened_kerf(const simulator::CutSolid& solid, const simulator::Bvh& bvh,
                                   const OpenedKerf& kerf);

}  // namespace hallux::ui
