/// Sawing in a cut after its step was declared done. It counts as what was sawn before: nothing
/// that is measured asks when *Done* was said; the ledger only tells that it happened.
/// Inside this room only.
#pragma once

#include <span>
#include <string>

#include "assessment/rebuild/cut_face.h"
#include "scenarios/scenario.h"
#include "simulator/record/record.h"

namespace hallux::assessment {

/// faces  of that cut
bool is_sawn_after_done(const scenarios::Scenario& scenario, const std::string& cut,
                        std::span<const CutFace> faces, const simulator::Recording& recording);

}  // namespace hallux::assessment
