/// The hinge that closes about the bridge that an operation wants left.
#pragma once

#include "simulator/bone/cut_bone.h"
#include "simulator/cutting/hinge/hinge.h"

namespace hallux::simulator {

/// Closes the bone about its bridge, between the two kerfs that leave least there.
/// bone    its pieces as they were numbered last, without those that were taken out
/// ensures the bone does not change; FacesMissing where fewer than two kerfs took bone at the
///         bridge
ClosedHinge close_bridge(CutBone& bone, const PlannedBridge& bridge);
/// The same with what lies in the wound said beside the bone.
ClosedHinge close_bridge(CutBone& bone, const CutSolid& solid, const PlannedBridge& bridge);

}  // namespace hallux::simulator
