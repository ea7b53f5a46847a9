/// The motion of a blade in its plane, and what it opens there.
#pragma once

#include <vector>

#include "simulator/cutting/field/kerf.h"

namespace hallux::simulator {

struct SweepPose {
  /// Middle of the tooth line.
  Vec3 tip_in_mesh_mm{0.0, 0.0, 0.0};
  /// Unit length.
  Vec3 direction{1.0, 0.0, 0.0};
};

struct Sweep {
  double width_mm = 0.0, depth_mm = 0.0;
  /// At least one.
  std::vector<SweepPose> poses;
};

/// A sweep as a kerf's field takes it.
struct BladePath {
  Blade blade;
  std::vector<PlanarPose> poses;
};

/// The sweep projected to a kerf's plane.
BladePath path_in_plane(const Sweep& sweep, const KerfPlane& kerf);

/// Opens what the blade covers on its way from pose to pose; a turn is followed in steps.
void stamp_motion(KerfField& field, const Blade& blade, const PlanarPose& from,
                  const PlanarPose& to);

}  // namespace hallux::simulator
