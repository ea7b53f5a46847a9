#include "simulator/cutting/hole/capsule.h"

#include <algorithm>
#include <cmath>

namespace hallux::simulator {

double distance_mm(const Capsule& capsule, const Vec3& point_in_body_mm) noexcept {
  const Vec3 nearest_mm = closest_on_segment(axis_of(capsule), point_in_body_mm);
  return length_of(point_in_body_mm - nearest_mm) - capsule.radius_mm;
}

double distance_mm(const Capsule& capsule, const Segment& segment_in_body) noexcept {
  return std::sqrt(squared_distance_mm2(axis_of(capsule), segment_in_body)) - capsule.radius_mm;
}

double distance_mm(const Capsule& a, const Capsule& b) noexcept {
  return distance_mm(a, axis_of(b)) - b.radius_mm;
}

bool is_in_capsule(std::span<const Capsule> capsules, const Vec3& point_in_body_mm) noexcept {
  return std::any_of(capsules.begin(), capsules.end(), [&](const Capsule& capsule) {
    const Vec3 nearest_mm = closest_on_segment(axis_of(capsule), point_in_body_mm);
    return squared_length(point_in_body_mm - nearest_mm) < capsule.radius_mm * capsule.radius_mm;
  });
}

}  // namespace hallux::simulator
