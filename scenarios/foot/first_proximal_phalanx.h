/// The parametric first proximal phalanx: as the first metatarsal, with a base facet that is square
/// to the shaft. Inside this corner only.
#pragma once

#include "scenarios/foot/landmarks.h"
#include "scenarios/foot/make_bone.h"
#include "simulator/base/progress.h"

namespace hallux::scenarios {

/// errors  as make_bone; besides where an eminence is asked for, which this bone has not
/// source  docs/foot.md; table `tables/first_proximal_phalanx.txt`; promises as make_bone
simulator::Bone make_first_proximal_phalanx(const BoneTable& table, const BoneRequest& request,
                                            const Progress& progress = {});

/// The shipped table of the first proximal phalanx (PP1).
BoneTable first_proximal_phalanx_table();

/// Its landmarks, as docs/foot.md lists them; `sources` is of such a bone.
std::vector<simulator::Landmark> first_proximal_phalanx_landmarks(const LandmarkSources& sources);

}  // namespace hallux::scenarios
