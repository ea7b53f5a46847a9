/// The first proximal phalanx with its base facet as oblique as it was measured; the shipped table
/// levels it.
#pragma once

#include "scenarios/foot/first_proximal_phalanx.h"

namespace hallux::scenarios_test {

inline scenarios::BoneTable measured_phalanx_table() {
  scenarios::BoneTable table = scenarios::first_proximal_phalanx_table();
  table.base.x_mm = 4.69;
  table.base.tilt_z = 0.419;
  table.base.curve_yz_per_mm = -0.0198;
  return table;
}

}  // namespace hallux::scenarios_test
