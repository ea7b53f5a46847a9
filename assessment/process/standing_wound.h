/// The wound as samples are followed again in it: every fragment as it lies at that moment.
/// Inside this room only.
#pragma once

#include "simulator/contact/tissue.h"
#include "simulator/contact/wound.h"
#include "simulator/cutting/field/kerf_set.h"

namespace hallux::assessment {

/// Borrows both. A recording holds no bodies of pieces: bone that was picked up is still there, and
/// of a fragment that was parted the bone beyond its walls as well.
simulator::Wound standing_wound(const simulator::TissueMap& tissue,
                                const simulator::KerfSet& kerfs);

}  // namespace hallux::assessment
