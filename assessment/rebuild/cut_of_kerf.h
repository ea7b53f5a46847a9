/// Which planned cut each kerf was meant for. Inside this corner only.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "assessment/rebuild/rebuild.h"
#include "assessment/rebuild/step_of_kerf.h"
#include "scenarios/plan.h"

namespace hallux::assessment {

/// A kerf belongs to the cut whose step was at hand while it was sawn (see cuts_at_hand); where the
/// steps say nothing, to the cut whose plan it lies nearest to, where a degree counts as a
/// millimetre. A wedge has two cuts: where kerfs that were sawn at least half way all fall to one
/// of them, or the steps say nothing of two such kerfs, their order along the bone where the blade
/// enters decides; where their planes cross there, the kerf that loses least by it goes to the cut
/// that has none. Else a wedge a few degrees off would be one cut made twice, or one turned over.
/// shape   one index into plan.cuts per kerf
/// needs   plan.cuts is not empty; evidence is of the recording that `rebuilt` was made from
/// source  docs/metrics.md, "Which face"
std::vector<std::size_t> cuts_of_kerfs(const RebuiltBone& rebuilt, const scenarios::Plan& plan,
                                       const StepEvidence& evidence);

/// How much of what the cut was to open this kerf opened: 1 only where nothing is missing. Without
/// a hinge the section, as far as the cut's window reaches; with one, the section up to the
/// thickest bridge that is still on target, or to where the two kerfs lie in each other.
double done_fraction_of(const RebuiltBone& rebuilt, std::int32_t kerf, const scenarios::Plan& plan,
                        std::size_t cut);

}  // namespace hallux::assessment
