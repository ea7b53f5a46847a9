#include "simulator/tool/wire.h"

namespace hallux::simulator {

bool is_made(const Wire& wire) noexcept {
  return wire_diameter_range_mm.holds(wire.diameter_mm) &&
         wire_length_range_mm.holds(wire.length_mm) &&
         wire_point_range.holds(wire.point_mm / wire.diameter_mm);
}

}  // namespace hallux::simulator
