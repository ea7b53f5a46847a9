#include "assessment/blade_track.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "assessment/process/tools_used.h"
#include "simulator/record/sample_force.h"

namespace hallux::assessment {

namespace {

using simulator::Recording;
using simulator::ToolSample;
using simulator::ToolStatus;

/// Both ends and the middle of the tooth line at one sample.
std::array<Vec3, 3> teeth_at(const ToolSample& sample, const RigidTransform& bone_from_world,
                             double width_mm) {
  const RigidTransform bone_from_tool = bone_from_world * transform_from(sample.world_from_tool);
  return {transform_point(bone_from_tool, Vec3{0.0, -0.5 * width_mm, 0.0}),
          transform_point(bone_from_tool, Vec3{0.0, 0.0, 0.0}),
          transform_point(bone_from_tool, Vec3{0.0, 0.5 * width_mm, 0.0})};
}

}  // namespace

std::vector<ToothPoint> cutting_tooth_points(const Recording& recording, const RebuiltBone& rebuilt,
                                             const simulator::Bones& bones, std::int32_t kerf) {
  const RigidTransform bone_from_world = inverse(bones[bone_of(rebuilt, kerf)].world_from_bone);
  const double width_mm = blade_of_kerf(recording, rebuilt, kerf).width_mm;
  std::vector<ToothPoint> points;
  for (const ToolSample& sample : recording.samples) {
    if (sample.kerf != kerf || !has(sample.status, ToolStatus::Cutting)) continue;
    for (const Vec3& tooth : teeth_at(sample, bone_from_world, width_mm)) {
      points.push_back({tooth, sample.tick});
    }
  }
  return points;
}

std::optional<Reach> measure_reach(const Recording& recording, const RebuiltBone& rebuilt,
                                   const simulator::Bones& bones, std::int32_t kerf,
                                   const ReachLimit& limit) {
  const RigidTransform bone_from_world = inverse(bones[bone_of(rebuilt, kerf)].world_from_bone);
  const double width_mm = blade_of_kerf(recording, rebuilt, kerf).width_mm;
  std::optional<Reach> reach;
  double deepest_mm = 0.0;
  for (const ToolSample& sample : recording.samples) {
    if (sample.kerf != kerf || !has(sample.status, ToolStatus::SawOn)) continue;
    double outward_mm = -INFINITY;
    for (const Vec3& tooth : teeth_at(sample, bone_from_world, width_mm)) {
      outward_mm = std::max(outward_mm, glm::dot(limit.outward, tooth));
    }
    if (!reach) reach = Reach{sample.tick, {}, 0.0};
    if (sample.tick == reach->deepest_tick || outward_mm > deepest_mm) {
      deepest_mm = outward_mm;
      reach->deepest_tick = sample.tick;
    }
    if (reach->passed_tick || outward_mm <= limit.limit_mm) continue;
    reach->passed_tick = sample.tick;
    reach->passing_force_newton = simulator::force_size_newton(sample);
  }
  return reach;
}

}  // namespace hallux::assessment
