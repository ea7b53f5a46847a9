#include "tests/ui/render/drilled_bone.h"

#include "simulator/base/check.h"
#include "simulator/cutting/hole/hole_rim.h"
#include "simulator/mesh/bvh.h"

namespace hallux::tests {

namespace {

using namespace simulator;

/// Longer than the bone is thick.
constexpr double far_mm = 60.0;

std::vector<HoleRim> rims_on(const OperatingWorld& world, const Vec3& from_in_bone_mm,
                             const Vec3& way, double radius_mm) {
  const IndexedMesh& skin = world.mesh().solid.mesh;
  return hole_rims(skin, Bvh(skin),
                   {from_in_bone_mm, from_in_bone_mm + 2.0 * far_mm * way, radius_mm});
}

}  // namespace

RigidTransform DrillLine::world_from_tool(double depth_mm) const noexcept {
  return world_from_line * RigidTransform{Quat(1.0, 0.0, 0.0, 0.0), Vec3(depth_mm, 0.0, 0.0)};
}

DrillLine drill_line(const OperatingWorld& world, const Vec3& through_in_bone_mm,
                     const Vec3& way_in_bone) {
  const Vec3 way = glm::normalize(way_in_bone), from_mm = through_in_bone_mm - far_mm * way;
  const std::vector<HoleRim> rims = rims_on(world, from_mm, way, 0.2);
  CHECK(rims.size() >= 2);
  const Vec3 beside = std::abs(way.x) < 0.8 ? Vec3(1.0, 0.0, 0.0) : Vec3(0.0, 1.0, 0.0);
  const RigidTransform bone_from_line{rotation_from_axes(way, glm::cross(beside, way)),
                                      from_mm + rims.front().way_mm * way};
  return {world.phalanx().world_from_bone * bone_from_line,
          rims.back().way_mm - rims.front().way_mm};
}

ui::HoleInScene hole_at(const OperatingWorld& world, const DrillLine& line, double radius_mm) {
  const RigidTransform bone_from_line =
      inverse(world.phalanx().world_from_bone) * line.world_from_line;
  const Vec3 way = axis_x(bone_from_line);
  const std::vector<HoleRim> rims =
      rims_on(world, bone_from_line.translation_mm - far_mm * way, way, radius_mm);
  CHECK(!rims.empty());
  ui::HoleInScene hole{{}, -axis_x(line.world_from_line)};
  for (const Vec3& point_mm : rims.front().points_mm)
    hole.rim_mm.push_back(transform_point(world.phalanx().world_from_bone, point_mm));
  return hole;
}

}  // namespace hallux::tests
