/// Closes the wedge that two kerfs leave between them: one half of the bone turns about the bridge
/// that stands.
#pragma once

#include <cstddef>
#include <vector>

#include "simulator/bone/sawn_bone.h"
#include "simulator/cutting/hinge/hinge.h"

namespace hallux::simulator {

struct WedgeClosure {
  HingeOutcome outcome = HingeOutcome::Stiff;
  double thickness_mm = 0.0;
  /// Where it closed.
  double angle_rad = 0.0;
  /// Places in the bodies: the wedge, the half beyond the first kerf, the half beyond the second.
  /// The halves are one body where the bone stays undivided.
  std::size_t wedge = 0, fixed = 0, moved = 0;
};

/// The wedge is the body that lies wholly between the kerfs and has a wall of each. The hinge's
/// line is where the kerfs' planes meet, its outward direction leads from the wedge to the far
/// cortex, and the half beyond the second kerf turns.
/// ensures where it closed, the body that held both halves is the fixed half and the moved one, in
///         its new place, stands behind all others; where it broke, the same without a turn; else
///         the bodies stay as they are
/// errors  MeshError where the planes are parallel or no body is the wedge
/// thread  any; a job
WedgeClosure close_wedge(SawnBone& bone, const OpenedKerf& first, const OpenedKerf& second,
                         std::vector<CutSolid>& bodies);

}  // namespace hallux::simulator
