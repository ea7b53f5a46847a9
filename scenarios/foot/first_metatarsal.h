/// The parametric first metatarsal: a bone from a table of stations, closed and the same bytes each
/// time. Inside this corner only.
#pragma once

#include "scenarios/foot/landmarks.h"
#include "scenarios/foot/make_bone.h"
#include "simulator/base/progress.h"

namespace hallux::scenarios {

/// source  docs/foot.md; table `tables/first_metatarsal.txt`; promises and errors as make_bone
simulator::Bone make_first_metatarsal(const BoneTable& table, const BoneRequest& request,
                                      const Progress& progress = {});

/// The shipped table of the first metatarsal (MT1A).
BoneTable first_metatarsal_table();

/// Its landmarks, as docs/foot.md lists them; `sources` is of such a bone.
std::vector<simulator::Landmark> first_metatarsal_landmarks(const LandmarkSources& sources);

}  // namespace hallux::scenarios
