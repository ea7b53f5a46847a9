#include "simulator/cutting/remaining/remaining_bone.h"

#include <algorithm>
#include <cmath>

#include "simulator/cutting/remaining/remaining_search.h"

namespace hallux::simulator {

bool RemainingBone::is_taken_out(const Vec3& point_in_bone_mm) const noexcept {
  // By parity: a sawn body's mesh has slivers, near which the sign of its distance can be wrong.
  return std::any_of(taken_out.begin(), taken_out.end(),
                     [&](const Bvh* body) { return body->contains(point_in_bone_mm); });
}

bool RemainingBone::contains(const Vec3& point_in_bone_mm) const noexcept {
  return !kerfs.is_open(point_in_bone_mm) && original.contains(point_in_bone_mm) &&
         !is_taken_out(point_in_bone_mm);
}

std::optional<RemainingPoint> RemainingBone::nearest(const Vec3& point_in_bone_mm,
                                                     double within_mm) const noexcept {
  RemainingSearch search(*this, point_in_bone_mm, within_mm);
  return search.run();
}

Advance RemainingBone::first_contact(std::span<const Vec3> points_in_body_mm,
                                     const RigidMotion& motion) const noexcept {
  double radius_mm2 = 0.0;
  for (const Vec3& point : points_in_body_mm) {
    radius_mm2 = std::max(radius_mm2, squared_length(point));
  }
  const auto gap_mm = [&](const RigidTransform& pose, double within_mm) {
    double least_mm = within_mm;
    for (const Vec3& point : points_in_body_mm) {
      const std::optional<RemainingPoint> found = nearest(transform_point(pose, point), least_mm);
      if (found) least_mm = found->distance_mm;
    }
    return least_mm;
  };
  return advance_until_contact(motion, std::sqrt(radius_mm2), gap_mm);
}

}  // namespace hallux::simulator
