#include "scenarios/site/planned_window.h"

#include <algorithm>
#include <cmath>

#include "simulator/base/elementary.h"

namespace hallux::scenarios {

PlannedWindow window_before(const PlannedHinge& hinge, double kerf_mm) noexcept {
  const simulator::HingeLine& line = hinge.bridge.line;
  const double spare_mm = hinge.target_high_mm - line.thickness_mm;
  const double wedge_rad = std::abs(hinge.wedge_rad);
  const double tangent = elementary::sin(wedge_rad) / elementary::cos(wedge_rad);
  const double overlap_mm = tangent > 0.0 ? 0.5 * kerf_mm / tangent : 0.0;
  return {line.outward,
          glm::dot(line.outward, line.point_in_bone_mm) - std::max({0.0, spare_mm, overlap_mm})};
}

}  // namespace hallux::scenarios
