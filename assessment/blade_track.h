/// Where the blade's teeth were while the saw ran in one kerf. Inside this corner only.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "assessment/metrics/blade_flatness.h"
#include "assessment/rebuild/rebuild.h"
#include "simulator/mesh/bone.h"
#include "simulator/record/record.h"

namespace hallux::assessment {

/// Ends and middle of the tooth line at each tick in which the blade cut in this kerf.
std::vector<ToothPoint> cutting_tooth_points(const simulator::Recording& recording,
                                             const RebuiltBone& rebuilt,
                                             const simulator::Bones& bones, std::int32_t kerf);

/// Points p with outward . p = limit, beyond which the teeth are not to go.
struct ReachLimit {
  /// Unit.
  Vec3 outward{0.0, 0.0, 1.0};
  double limit_mm = 0.0;
};

/// How far the teeth went while the saw ran in this kerf, in cut bone or in the air beyond.
struct Reach {
  /// The first at which they were furthest outward.
  std::int64_t deepest_tick = 0;
  /// The first beyond the limit; nothing where they stayed within.
  std::optional<std::int64_t> passed_tick;
  /// Size of the force on the hand at that tick.
  double passing_force_newton = 0.0;
};

/// errors  nothing where the saw never ran in this kerf
std::optional<Reach> measure_reach(const simulator::Recording& recording,
                                   const RebuiltBone& rebuilt, const simulator::Bones& bones,
                                   std::int32_t kerf, const ReachLimit& limit);

}  // namespace hallux::assessment
