/// Whether the steps were carried out in their order. Inside this room only.
#pragma once

#include "assessment/process/finding.h"
#include "assessment/rebuild/evidence.h"

namespace hallux::assessment {

/// The longest part of the required steps that was carried out in their order, as a share of all of
/// them: verify counts from its Done, a cut from the first tick of sawing in it, a removal from the
/// piece that came out last, closing from the hinge that closed, finish from the end that the
/// operator declared. A step without its event was not carried out. 1 where no step is required.
/// The moment is that of the first step which the longest part leaves out; the end where that was
/// not carried out, or none is left out.
Finding measure_step_order(const Evidence& evidence);

}  // namespace hallux::assessment
