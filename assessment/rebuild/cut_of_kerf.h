/// Which planned cut each kerf was meant for. Inside this corner only.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "assessment/rebuild/rebuild.h"
#include "scenarios/plan.h"

namespace hallux::assessment {

/// A kerf belongs to the cut whose plan it lies nearest to; a degree counts as a millimetre. With
/// one exception: a wedge has two cuts, and where two kerfs were sawn at least half way but both
/// lie nearest to one of them, the kerf that loses least by it goes to the other. Else a wedge a
/// few degrees off would be one cut made twice.
/// shape   one index into plan.cuts per kerf
/// needs   plan.cuts is not empty
std::vector<std::size_t> cuts_of_kerfs(const RebuiltBone& rebuilt, const scenarios::Plan& plan);

/// How much of what the cut was to open this kerf opened: 1 only where nothing is missing. Without
/// a hinge the section; with one, the section up to the thickest bridge that is still on target, or
/// to where the two kerfs lie in each other.
double done_fraction_of(const RebuiltBone& rebuilt, std::int32_t kerf,
                        const scenarios::PlannedHinge* hinge);

}  // namespace hallux::assessment
