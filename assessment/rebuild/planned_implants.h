/// Which implant of an attempt stands for which planned one, and how often each was tried.
/// Inside this corner only.
#pragma once

#include "assessment/rebuild/implants.h"
#include "scenarios/fixation/planned_fixation.h"

namespace hallux::assessment {

/// Fills `planned` and `insertions`.
/// ensures each planned implant has at most one, of its kind: the one whose ends lie nearest to the
///         planned ones, of what still lies there first unless it is planned to come out again.
///         What was taken out and has no plan of its own was a try for the nearest one set after it
/// plan    with implants in the frame of the first bone
void assign_planned(Fixation& fixation, const scenarios::PlannedFixation& plan);

}  // namespace hallux::assessment
