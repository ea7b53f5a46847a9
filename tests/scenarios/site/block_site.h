/// Operations on a block of bone, whose sections one can compute by hand: a cut along it and a
/// wedge across it.
#pragma once

#include "scenarios/plan.h"
#include "simulator/cutting/field/kerf_set.h"
#include "simulator/cutting/pieces/cut_solid.h"
#include "simulator/mesh/bvh.h"
#include "simulator/record/record.h"

namespace hallux::tests {

/// 33 x 13 x 15 mm from x = 0 on; y dorsal, z lateral.
simulator::Bone site_block();

/// A scenario on that block, its bone, and a blade that has been somewhere.
class BlockSite {
 public:
  explicit BlockSite(scenarios::Scenario asked);

  /// Freezes the plane of a planned cut, shifted along its normal.
  simulator::CutEvent freeze(std::size_t cut, double shifted_mm = 0.0);
  /// The blade's teeth pass from before the bone to `depth_mm` beyond the cut's entry, their middle
  /// `along_mm` from the middle of the section.
  void saw(std::int32_t kerf, double along_mm, double depth_mm);

  scenarios::Scenario scenario;
  simulator::Bone bone;
  scenarios::Plan plan;
  simulator::CutSolid whole;
  simulator::Bvh bvh;
  simulator::KerfSet kerfs;

 private:
  RigidTransform bone_from_blade(std::size_t cut, double along_mm, double depth_mm) const;

  std::vector<std::size_t> cut_of_kerf_;
  std::vector<double> shift_of_kerf_;
  std::int64_t tick_ = 0;
};

/// A cut along the block from dorsal, 4 mm medial of its middle: a section of 33 x 13 mm.
scenarios::Scenario along_scenario(double blade_width_mm);
/// The shipped wedge, with its blade of that width.
scenarios::Scenario wedge_scenario(double blade_width_mm);

}  // namespace hallux::tests
