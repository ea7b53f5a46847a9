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

double RemainingBone::signed_distance_mm(const Vec3& point_in_bone_mm,
                                         double within_mm) const noexcept {
  const std::optional<RemainingPoint> found = nearest(point_in_bone_mm, within_mm);
  const double distance_mm = found ? found->distance_mm : within_mm;
  return contains(point_in_bone_mm) ? -distance_mm : distance_mm;
}

std::optional<RemainingPoint> RemainingBone::first_hit(const Vec3& origin_mm, const Vec3& direction,
                                                       double within_mm) const noexcept {
  double along_mm = 0.0;
  if (!original.contains(origin_mm)) {
    // What stands lies within the original bone: the ray may go there at once.
    const std::optional<RayHit> hit = original.first_hit(origin_mm, direction);
    if (!hit) return std::nullopt;
    along_mm = std::max(0.0, hit->distance_mm - 0.5 * contact_tolerance_mm);
  }
  for (int i = 0; i < advance_limit && along_mm < within_mm; ++i) {
    std::optional<RemainingPoint> found =
        nearest(origin_mm + along_mm * direction, within_mm - along_mm + contact_tolerance_mm);
    if (!found) return std::nullopt;
    if (found->distance_mm <= contact_tolerance_mm) {
      found->distance_mm = along_mm;
      return found;
    }
    along_mm += found->distance_mm - 0.5 * contact_tolerance_mm;
  }
  return std::nullopt;
}

Advance RemainingBone::first_contact(std::span<const Vec3> points_in_tool_mm,
                                     const RigidMotion& motion) const noexcept {
  double reach_mm2 = 0.0;
  for (const Vec3& point : points_in_tool_mm)
    reach_mm2 = std::max(reach_mm2, glm::dot(point, point));
  const auto gap_mm = [&](const RigidTransform& pose, double within_mm) {
    double least_mm = within_mm;
    for (const Vec3& point : points_in_tool_mm) {
      const std::optional<RemainingPoint> found = nearest(transform_point(pose, point), least_mm);
      if (found) least_mm = found->distance_mm;
    }
    return least_mm;
  };
  return advance_until_contact(motion, std::sqrt(reach_mm2), gap_mm);
}

}  // namespace hallux::simulator
