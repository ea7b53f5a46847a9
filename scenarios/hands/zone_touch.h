/// How a blade is led into a danger zone through the air. Inside this corner only.
///
///        .-- halfway --.
///       /    (bone)     \        round the bone where the zone lies on its other side,
///     home            there      then along the feed into the zone
#pragma once

#include <optional>
#include <string>

#include "scenarios/plan.h"
#include "simulator/base/transform.h"
#include "simulator/tool/saw.h"

namespace hallux::scenarios {

struct ZoneTask {
  std::string zone;
  /// Of the blade in front of the cut from which it comes; x the feed.
  RigidTransform bone_from_home;
};

struct ZoneTouch {
  /// Of the blade with its teeth in the zone; x the feed.
  RigidTransform bone_from_blade = {};
  /// A way round, its feed counted from the same point; none where the straight way is free.
  std::optional<RigidTransform> bone_from_halfway = std::nullopt;
  /// The least distance of the blade on its way in from bone and from the other zones; below 0: no
  /// way is free.
  double room_mm = 0.0;
};

/// Of the ways that are free the one most like that of the cut; where none is, the one with most
/// room. All of it is said in the frame of the first bone.
/// errors  ScenarioError where the plan has no such zone
ZoneTouch plan_touch(const simulator::Bones& bones, const Plan& plan, const simulator::Blade& blade,
                     const ZoneTask& task);

}  // namespace hallux::scenarios
