#include "simulator/tool/drill.h"

namespace hallux::simulator {

bool is_made(const DrillBit& bit) noexcept {
  return drill_diameter_range_mm.holds(bit.diameter_mm) &&
         drill_length_range_mm.holds(bit.length_mm) &&
         drill_point_range.holds(bit.point_mm / bit.diameter_mm);
}

}  // namespace hallux::simulator
