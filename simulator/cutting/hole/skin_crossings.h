/// Where a straight line crosses a bone's skin, and the parts of it within the bone: the cortices
/// that a wire or a screw holds in.
///
/// Asked of the outer skin alone: the canal is a void within the bone, no cortex. Through an edge
/// or a corner of the mesh a line passes exactly once; a skin that is touched and not entered is
/// not crossed.
#pragma once

#include <vector>

#include "simulator/cutting/hole/skin_along_axis.h"

namespace hallux::simulator {

/// The parts of the endless line within the closed skin, in order; heights are ways from `from_mm`
/// towards `to_mm` [mm], negative before it.
/// needs   the points are apart
/// thread  any but haptic: fills vectors
std::vector<InsideInterval> inside_intervals(const Bvh& skin, const Vec3& from_mm,
                                             const Vec3& to_mm);

struct SkinCrossing {
  /// From the segment's beginning.
  double way_mm = 0.0;
  Vec3 point_mm{0.0, 0.0, 0.0};
  bool goes_in = false;
  std::uint32_t triangle = 0;
};

/// The crossings of the skin by the segment, in order from its beginning. Their count is the
/// cortices that an implant along it engages.
std::vector<SkinCrossing> skin_crossings(const Bvh& skin, const Vec3& from_mm, const Vec3& to_mm);

}  // namespace hallux::simulator
