/// Cuts begun on bones that are not operated on. Inside this room only.
#pragma once

#include "assessment/process/finding.h"
#include "assessment/rebuild/evidence.h"

namespace hallux::assessment {

/// How many cuts were begun on a bone on which the plan lays none; a cut that was begun elsewhere
/// and went on into such a bone is none of them. Its moment is the first one's, from the kerf's
/// beginning to its last tick of cutting.
Finding measure_wrong_bones(const Evidence& evidence);

}  // namespace hallux::assessment
