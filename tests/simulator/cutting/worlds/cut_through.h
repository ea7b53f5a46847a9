/// Whole cuts on the worlds of the tests, and what must hold after each.
#pragma once

#include <cstdint>
#include <vector>

#include "simulator/cutting/solid/remove_slab.h"

namespace hallux::tests {

/// The kerf plane through a point; its x axis is `x_hint`, made square to the normal.
simulator::KerfPlane plane_through(const Vec3& point_mm, const Vec3& normal, double thickness_mm,
                                   const Vec3& x_hint = Vec3(0.31, 0.77, 0.56));
/// The same with axes along the world's, for tests of exact coincidence; `axis` 0, 1 or 2 is the
/// normal.
simulator::KerfPlane axis_plane(std::size_t axis, double offset_mm, double thickness_mm);

struct CutOutcome {
  simulator::CutSolid solid;
  simulator::Section section;
  /// From section areas.
  double removed_mm3 = 0.0;
};

/// Removes every region of the plane's slab.
CutOutcome cut_through(const simulator::CutSolid& solid, const simulator::KerfPlane& plane,
                       std::int32_t kerf = 0);

/// Fails the test unless each directed edge occurs once with its opposite, all points are finite
/// and used, and each triangle has an origin.
void expect_closed(const simulator::CutSolid& solid);
/// Fails the test unless pieces, debris and removed volume add up to what was there.
/// shape   tolerance: 1e-9 of the volume, a thousandfold of what summing 1e5 terms can lose
void expect_balance(const simulator::CutSolid& before, const CutOutcome& outcome);

}  // namespace hallux::tests
