/// The strokes of a hand without errors: where the blade goes while a plan is carried out.
#pragma once

#include <cstddef>
#include <vector>

#include "scenarios/plan.h"
#include "simulator/cutting/field/kerf.h"

namespace hallux::scenarios {

struct PlannedStroke {
  /// Of the plan, in the frame of whose bone it is said.
  std::size_t cut = 0;
  /// x the feed, y along the teeth.
  simulator::KerfPlane plane;
  /// The middle of the teeth, along them.
  double along_mm = 0.0;
  /// Feed at which bone begins, and to which the stroke goes.
  double first_mm = 0.0, last_mm = 0.0;

  /// The blade at this feed.
  RigidTransform bone_from_tool(double feed_mm) const noexcept {
    return plane.bone_from_kerf *
           RigidTransform{Quat(1.0, 0.0, 0.0, 0.0), Vec3(feed_mm, along_mm, 0.0)};
  }
};

/// In the order of the scenario's steps, each cut's strokes as its hand makes them.
/// errors  ScenarioError where a planned face misses the bone
std::vector<PlannedStroke> planned_strokes(const Scenario& scenario, simulator::Bones bones,
                                           const Plan& plan);

}  // namespace hallux::scenarios
