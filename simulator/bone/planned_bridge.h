/// The bridge that an operation wants left, and the hinge that closes about it.
#pragma once

#include "simulator/bone/cut_bone.h"
#include "simulator/cutting/hinge/hinge.h"

namespace hallux::simulator {

/// A bridge that an operation wants left and closed, said in the bone frame.
struct PlannedBridge {
  HingeLine line;
  /// From the half that stays to the one that turns.
  Vec3 toward_moved{1.0, 0.0, 0.0};
  double breaks_below_mm = 0.3, bends_up_to_mm = 2.5;
};

/// Closes the bone about its bridge, between the two kerfs that leave least there.
/// bone    its pieces as they were numbered last, without those that were taken out
/// ensures the bone does not change; FacesMissing where fewer than two kerfs took bone at the
///         bridge
ClosedHinge close_bridge(CutBone& bone, const PlannedBridge& bridge);

}  // namespace hallux::simulator
