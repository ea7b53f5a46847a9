/// Passes of a blade that is narrower than the bone: side by side in one plane.
///
///        feed         tooth line -->
///          |     [ pass 1 ][ pass 2 ]
///          v    (     the section    )
#pragma once

#include <vector>

#include "scenarios/plan.h"
#include "simulator/cutting/pieces/cut_solid.h"
#include "simulator/mesh/bvh.h"

namespace hallux::scenarios {

struct PlannedPasses {
  /// Unit, in the face: the blade's feed, and along its tooth line.
  Vec3 feed_in_bone{1.0, 0.0, 0.0}, along_in_bone{0.0, 1.0, 0.0};
  /// From the cut's entry along the tooth line: where the section that is to be sawn begins and
  /// ends.
  double low_mm = 0.0, high_mm = 0.0;
  /// Of the blade's middle in each pass, ascending, from the entry; at least one.
  std::vector<double> middles_mm;
};

/// Neighbours lie in each other by this, and the outer ones reach as far beyond the bone.
inline constexpr double pass_overlap_mm = 1.0;

/// How many passes a section needs that reaches so far along the teeth.
/// needs   width_mm > 0
int passes_needed(double extent_mm, double width_mm) noexcept;

/// needs   the plan is the scenario's on the bone of `whole`, uncut, with its tree
/// thread  any; milliseconds
PlannedPasses planned_passes(const Scenario& scenario, const Plan& plan, std::size_t cut,
                             const simulator::CutSolid& whole, const simulator::Bvh& bvh);

}  // namespace hallux::scenarios
