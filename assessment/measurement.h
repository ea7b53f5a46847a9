/// One metric of one cut or hinge, with the moment and the place that it is about.
#pragma once

#include <cstdint>
#include <string>

#include "simulator/base/vector.h"

namespace hallux::assessment {

struct Measurement {
  std::string metric;       ///< "angle_deg"; the unit is the last word
  std::string cut;          ///< the reference cut's name; empty where it is about a hinge
  std::string hinge;        ///< the hinge's name; empty where it is about one cut
  double value = 0.0;       ///< rounded to 1e-6 of its unit
  bool is_measured = true;  ///< false: no cut was made, value means nothing
  double done_fraction =
      1.0;                ///< below 1: the blade was stopped inside the bone; measured where it was
  std::string direction;  ///< "dorsal", "plantar-distal"; empty where the metric has no sign
  std::string detail;     ///< a clause with more numbers, said where points were lost; may be empty
  std::int64_t start_us = 0, end_us = 0;
  Vec3 place_in_bone_mm{0.0, 0.0, 0.0};
};

}  // namespace hallux::assessment
