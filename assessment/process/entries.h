/// How often the blade entered the bone, and how often it had to. Inside this room only.
#pragma once

#include "assessment/process/finding.h"
#include "assessment/rebuild/evidence.h"

namespace hallux::assessment {

/// The entries into the planned cuts beyond those that their sections need with this blade; its
/// moment is the last entry. An entry begins where a kerf takes the blade that was in none or in
/// another, or that was more than 3 mm away from where it left this one: drawing back to clear the
/// kerf is none. A section needs as many as the passes that the plan would lay over it, side by
/// side (see passes_needed): of the regions that the counting kerf's blade touched.
Finding measure_restarts(const Evidence& evidence);

}  // namespace hallux::assessment
