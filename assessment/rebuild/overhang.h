/// How far bone stands out beyond a planned face. Inside this room only.
#pragma once

#include "assessment/rebuild/rebuild.h"
#include "scenarios/plan.h"

namespace hallux::assessment {

struct Overhang {
  double over_mm = 0.0;
  /// As the bodies lie.
  Vec3 place_in_bone_mm{0.0, 0.0, 0.0};
};

/// Of what is left, the furthest point beyond the face between the cut's depth point and its exit,
/// along the way from one to the other; 0 where nothing stands out.
/// needs   the cut runs along the bone
Overhang measure_overhang(const RebuiltBone& rebuilt, const scenarios::PlannedCut& cut);

}  // namespace hallux::assessment
