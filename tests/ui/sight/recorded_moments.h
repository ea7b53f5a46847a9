/// The moments of a recorded attempt at which somebody watches teeth and kerf.
#pragma once

#include <vector>

#include "scenarios/scenario.h"
#include "simulator/record/record.h"
#include "ui/sight/view_judge.h"

namespace hallux::ui {

/// Every so many ticks at which the saw runs: the tool, and what the kerf that it is in, or was in
/// last, has open.
std::vector<WorkMoment> moments_of(const simulator::Recording& recording,
                                   const simulator::Blade& blade,
                                   const RigidTransform& world_from_bone, std::int64_t every_ticks);

}  // namespace hallux::ui
