/// The planned cut whose step was at hand while each kerf was sawn. Inside this corner only.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "assessment/rebuild/rebuild.h"
#include "scenarios/plan.h"
#include "scenarios/scenario.h"
#include "simulator/record/record.h"

namespace hallux::assessment {

/// The operation's steps and the recording that says when each was done; borrowed for the call.
struct StepEvidence {
  std::span<const scenarios::OperationStep> steps;
  const simulator::Recording& recording;
};

/// A step that was taken up again is at hand until it is done anew; else, of the cut steps that are
/// not done, the one that is done next; else the first of them. The moment is when a tenth of the
/// kerf's sawing was over: what is less lies in another step as a false start.
/// shape   one entry per kerf, an index into plan.cuts; nothing where the recording has no StepDone
///         of a cut step, or where all cuts were done by then
/// needs   rebuilt is of this recording; samples and events are in the order of their ticks
std::vector<std::optional<std::size_t>> cuts_at_hand(const RebuiltBone& rebuilt,
                                                     const scenarios::Plan& plan,
                                                     const StepEvidence& evidence);

}  // namespace hallux::assessment
