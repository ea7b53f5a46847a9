/// The bones of a patient as fragments, where they lie before anything is moved.
#pragma once

#include "simulator/mesh/bones.h"
#include "simulator/record/fragment_poses.h"

namespace hallux::simulator {

/// needs   at most bone_limit bones
FragmentPoses poses_of(const Bones& bones);

}  // namespace hallux::simulator
