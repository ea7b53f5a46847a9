/// A capsule in a body's frame: what a wire, a drill or a screw takes up, and what it leaves.
/// Inside this room only.
///
/// All points within `radius_mm` of the axis from one end to the other: a cylinder with a half ball
/// on either end. No mesh is cut for it.
#pragma once

#include <span>

#include "simulator/base/segment.h"

namespace hallux::simulator {

struct Capsule {
  Vec3 from_in_body_mm{0.0, 0.0, 0.0}, to_in_body_mm{0.0, 0.0, 0.0};
  double radius_mm = 1.0;

  friend bool operator==(const Capsule&, const Capsule&) = default;
};

inline Segment axis_of(const Capsule& capsule) noexcept {
  return {capsule.from_in_body_mm, capsule.to_in_body_mm};
}

/// From the capsule's surface, negative inside [mm].
/// thread  any; allocates nothing
double distance_mm(const Capsule& capsule, const Vec3& point_in_body_mm) noexcept;
/// From the capsule's surface to the nearest point of the segment; negative where it comes in: how
/// deep.
double distance_mm(const Capsule& capsule, const Segment& segment_in_body) noexcept;
/// Between two surfaces; negative where they overlap: how deep the nearer points of the axes are.
double distance_mm(const Capsule& a, const Capsule& b) noexcept;

/// Whether the point lies inside some of them.
bool is_in_capsule(std::span<const Capsule> capsules, const Vec3& point_in_body_mm) noexcept;

}  // namespace hallux::simulator
