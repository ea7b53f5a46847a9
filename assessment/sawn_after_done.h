/// Sawing in a cut after its step was declared done. It counts as what was sawn before: nothing
/// that is measured asks when *Done* was said; the ledger only tells that it happened.
/// Inside this corner only.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "assessment/measurement.h"
#include "assessment/rebuild/cut_face.h"
#include "scenarios/scenario.h"
#include "simulator/record/record.h"

namespace hallux::assessment {

/// Closes the first measurement of a cut with the rule, where teeth advanced in one of its kerfs
/// while its step was done; a step that was taken up again is not, until it is done anew.
/// needs   faces are of the cut; samples and events are in the order of their ticks
void note_sawn_after_done(std::vector<Measurement>& measurements,
                          const scenarios::Scenario& scenario, const std::string& cut,
                          std::span<const CutFace> faces, const simulator::Recording& recording);

}  // namespace hallux::assessment
