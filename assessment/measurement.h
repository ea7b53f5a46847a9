/// One metric of one cut or hinge, with the moment and the place that it is about.
/// Inside this corner only.
#pragma once

#include <cstdint>
#include <string>

#include "simulator/base/vector.h"

namespace hallux::assessment {

struct Measurement {
  /// "angle_deg"; the unit is the last word.
  std::string metric;
  /// The reference cut's name; empty where it is about a hinge.
  std::string cut;
  /// The hinge's name; empty where it is about one cut.
  std::string hinge;
  /// Rounded to 1e-6 of its unit.
  double value = 0.0;
  /// False: no cut was made, value means nothing.
  bool is_measured = true;
  /// Below 1: the blade was stopped inside the bone; measured where it was.
  double done_fraction = 1.0;
  /// "dorsal", "plantar-distal"; empty where the metric has no sign.
  std::string direction;
  /// A clause with more numbers, said where points were lost; may be empty.
  std::string detail;
  /// A sentence that closes its line, whatever was lost; may be empty.
  std::string note = {};
  std::int64_t start_us = 0, end_us = 0;
  Vec3 place_in_bone_mm{0.0, 0.0, 0.0};
};

}  // namespace hallux::assessment
