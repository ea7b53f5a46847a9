/// A block of bone with Silver's landmarks, and attempts to saw it: worlds whose numbers one can
/// compute by hand.
#pragma once

#include <cstdint>

#include "scenarios/scenario.h"
#include "simulator/mesh/bone.h"
#include "simulator/record/record.h"

namespace hallux::assessment::testing {

/// The block fills x 0 to 60, y -10 to 10 (dorsal), z -12 (medial) to 8. The plan is the plane z =
/// -8, waste medial of it; the sulcus lies at (50, 10, -7), the exit at (10, 0, -8).
inline constexpr double planned_z_mm = -8.0;
inline constexpr double block_mm3 = 60.0 * 20.0 * 20.0;
inline constexpr double kerf_mm = 0.5;

simulator::Bone block_bone();
/// Silver's bands on the block; a blade wide enough to take the whole section in one stroke.
scenarios::Scenario block_scenario();

struct Stroke {
  /// Of the finished face in the middle of the block.
  double face_z_mm = planned_z_mm;
  /// About the feed direction: positive lies deeper (lateral) distally.
  double tilt_rad = 0.0;
  /// Where the teeth stop; below -10 they are through.
  double last_y_mm = -11.0;
};

/// Freezes a plane at the dorsal side and saws down to `last_y_mm`, 0.05 mm a tick, after what is
/// recorded already.
void add_stroke(simulator::Recording& recording, const simulator::Bone& bone, const Stroke& stroke);

/// A piece that came free is taken out, a tick after what is recorded already.
void add_removal(simulator::Recording& recording, const Vec3& inside_mm);

}  // namespace hallux::assessment::testing
