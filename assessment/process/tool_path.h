/// How far the tools went for what they sawed and bored. Inside this room only.
#pragma once

#include <optional>

#include "assessment/process/finding.h"
#include "assessment/rebuild/evidence.h"
#include "simulator/mesh/bvh.h"

namespace hallux::assessment {

/// The way of the middle of the tooth line, or of a tip, while it was within 50 mm of the bone,
/// low-passed, divided by the shortest way of the plan: from where the tool was first, for each
/// stroke straight to where its bone begins, to its end and back; so for each wire of a step that
/// was done, and twice for each screw, which is drilled for. Nothing where no tool came near. Its
/// moment is the whole time near the bone.
/// surface  of the bone as it was, in its frame
/// errors   ScenarioError where a planned face misses the bone (see planned_strokes); those of
///          whoever keeps the tape
std::optional<Finding> measure_path_ratio(const Evidence& evidence, const simulator::Bvh& surface);

}  // namespace hallux::assessment
