/// Which strokes a blade needs to cover a section: side by side with an overlap, from the middle outwards.
#pragma once

#include <vector>

#include "simulator/cutting/section.h"

namespace hallux::scenarios {

/// In the blade's plane: x along the feed, y along the tooth line [mm].
struct Stroke {
  double along_mm = 0.0;  ///< middle of the tooth line
  double first_mm = 0.0;  ///< feed at which bone begins under the tooth line
  double last_mm = 0.0;   ///< feed at which it ends
};

/// needs   0 < overlap_mm < blade_width_mm
std::vector<Stroke> plan_strokes(const simulator::SectionRegion& region, double blade_width_mm,
                                 double overlap_mm);

}  // namespace hallux::scenarios
