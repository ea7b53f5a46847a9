/// Where the tool was in the bone's frame, and whether it was near the bone.
/// Inside this room only.
#pragma once

#include <cmath>

#include "simulator/base/transform.h"
#include "simulator/mesh/bvh.h"
#include "simulator/record/record.h"

namespace hallux::assessment {

/// The middle of the tooth line.
inline Vec3 tip_in_bone_mm(const simulator::ToolSample& sample,
                           const RigidTransform& bone_from_world) noexcept {
  return transform_point(bone_from_world, transform_from(sample.world_from_tool).translation_mm);
}

/// So far from the bone a tool still works on it.
inline constexpr double near_bone_mm = 50.0;

/// Whether places that follow each other are near the bone. A distance changes by no more than the
/// way, so most answers need no search.
class NearBone {
 public:
  /// Borrows the bone's surface.
  explicit NearBone(const simulator::Bvh& surface) noexcept : surface_(surface) {}

  bool holds(const Vec3& point_in_bone_mm) noexcept {
    const double way_mm = length_of(point_in_bone_mm - asked_in_bone_mm_);
    if (!is_asked_ || std::abs(distance_mm_ - near_bone_mm) <= way_mm) {
      is_asked_ = true;
      asked_in_bone_mm_ = point_in_bone_mm;
      distance_mm_ = surface_.signed_distance_mm(point_in_bone_mm);
    }
    return distance_mm_ < near_bone_mm;
  }

 private:
  const simulator::Bvh& surface_;
  Vec3 asked_in_bone_mm_{0.0, 0.0, 0.0};
  double distance_mm_ = 0.0;
  bool is_asked_ = false;
};

}  // namespace hallux::assessment
