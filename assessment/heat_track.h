/// Heat along a recording, followed again from its samples as the step followed it.
#pragma once

#include <cstddef>
#include <vector>

#include "assessment/progress.h"
#include "simulator/contact/heat.h"
#include "simulator/mesh/bone.h"
#include "simulator/record/record.h"

namespace hallux::assessment {

struct HeatTrack {
  /// Of the hottest bone at the end of each stretch [degrees Celsius].
  std::vector<double> hottest_celsius;
  simulator::HeatSummary summary;  ///< of the whole recording
};

/// One entry for each `stretch` samples, the last perhaps for fewer. Bone that was picked up still leads heat away here: a
/// recording holds no bodies of pieces.
/// needs   recording's samples and events are in the order of their ticks; stretch > 0
/// errors  Cancelled
/// thread  any
HeatTrack follow_heat(const simulator::Bone& bone, const simulator::BladeSize& blade,
                      double cycles_per_minute, const simulator::Recording& recording,
                      std::size_t stretch, const Progress& progress = {});

}  // namespace hallux::assessment
