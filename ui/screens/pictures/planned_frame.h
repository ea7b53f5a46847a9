/// A planned face as a frame to draw it in.
#pragma once

#include "scenarios/plan.h"
#include "simulator/base/transform.h"

namespace hallux::ui {

/// The middle of the face; z towards the waste, x from where the blade enters to where it comes
/// out.
RigidTransform bone_from_planned(const scenarios::PlannedCut& cut) noexcept;

}  // namespace hallux::ui
