/// The bone is divided in the plane of the kerf that left less, by taking out a slab without
/// thickness: nothing is lost, and the halves are told apart shell by shell. The joint runs through
/// the middle of the bridge's inner edge; contact is looked for beyond the bridge, where the halves
/// share points.
#include "simulator/cutting/hinge/hinge.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "simulator/cutting/pieces/edge_uses.h"
#include "simulator/cutting/slice/plane_slice.h"
#include "simulator/cutting/solid/remove_slab.h"

namespace hallux::simulator {

namespace {

/// Planes nearer to parallel than this (sine of 0.5 degree) say nothing about where they meet.
constexpr double least_sine = 0.0087;

/// Which triangles stand above the plane, by shells: after the division no shell lies on both
/// sides, and its furthest point says on which it is, whatever rounding did near the plane.
std::vector<bool> triangles_above(const IndexedMesh& mesh, const KerfAxes& axes) {
  DisjointSets shells = sets_by_edges(mesh.triangles);
  std::vector<double> furthest_mm(mesh.triangles.size(), 0.0);
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    double& shell_mm = furthest_mm[shells.root(i)];
    for (const std::uint32_t corner : mesh.triangles[i]) {
      const double corner_mm = height_mm(axes, mesh.points_mm[corner]);
      if (std::abs(corner_mm) > std::abs(shell_mm)) shell_mm = corner_mm;
    }
  }
  std::vector<bool> is_above(mesh.triangles.size());
  for (std::uint32_t i = 0; i < is_above.size(); ++i) {
    is_above[i] = furthest_mm[shells.root(i)] >= 0.0;
  }
  return is_above;
}

CutSolid half_of(const CutSolid& solid, const std::vector<bool>& is_above, bool wants_above) {
  constexpr std::uint32_t unused = 0xffffffffU;
  std::vector<std::uint32_t> new_index(solid.mesh.points_mm.size(), unused);
  CutSolid half;
  for (std::size_t i = 0; i < solid.mesh.triangles.size(); ++i) {
    if (is_above[i] != wants_above) continue;
    Triangle corners = solid.mesh.triangles[i];
    for (std::uint32_t& corner : corners) {
      if (new_index[corner] == unused) {
        new_index[corner] = static_cast<std::uint32_t>(half.mesh.points_mm.size());
        half.mesh.points_mm.push_back(solid.mesh.points_mm[corner]);
      }
      corner = new_index[corner];
    }
    half.mesh.triangles.push_back(corners);
    half.sources.push_back(solid.sources[i]);
  }
  return half;
}

/// Along the line in which the kerfs' planes meet; parallel planes leave the planned direction.
Vec3 joint_direction(const HingeRequest& request, const KerfAxes& dividing) noexcept {
  const Vec3 meeting = glm::cross(axes_of(request.first).z, axes_of(request.second).z);
  const Vec3& axis = request.bridge.line.axis;
  const Vec3 planned = axis - glm::dot(axis, dividing.z) * dividing.z;
  if (glm::dot(meeting, meeting) < least_sine * least_sine) return unit(planned);
  return unit(meeting);
}

/// The joint in the dividing plane, through the middle of the bridge's inner edge, signed so that a
/// positive turn closes.
TurnAxis joint_of(const HingeRequest& request, const KerfAxes& dividing, const Vec3& middle_mm) {
  TurnAxis joint;
  joint.point_mm = middle_mm;
  joint.axis = joint_direction(request, dividing);
  joint.toward_gap = unit(glm::cross(dividing.z, joint.axis));
  if (glm::dot(joint.toward_gap, request.bridge.line.outward) > 0.0) joint.toward_gap *= -1.0;
  const bool is_moved_above = glm::dot(dividing.z, request.bridge.toward_moved) > 0.0;
  const Vec3 toward_moved = is_moved_above ? dividing.z : -dividing.z;
  joint.axis = glm::cross(toward_moved, joint.toward_gap);
  return joint;
}

double squared_radius_mm2(const TurnAxis& joint, const Vec3& point_mm) noexcept {
  return squared_length(glm::cross(point_mm - joint.point_mm, joint.axis));
}

double radius_around(const TurnAxis& joint, const DividedBone& divided) noexcept {
  double most_mm2 = 0.0;
  for (const std::vector<Vec3>& corners_mm : divided.bridges_in_bone_mm) {
    for (const Vec3& corner_mm : corners_mm) {
      most_mm2 = std::max(most_mm2, squared_radius_mm2(joint, corner_mm));
    }
  }
  return std::sqrt(most_mm2);
}

/// Whether what the plane crosses beside the bridge is more than may break. The bridge is what lies
/// nearest the joint.
bool is_held_elsewhere(const DividedBone& divided, const TurnAxis& joint) noexcept {
  double nearest_mm2 = std::numeric_limits<double>::infinity(), bridge_mm2 = 0.0, all_mm2 = 0.0;
  for (std::size_t i = 0; i < divided.bridges_mm2.size(); ++i) {
    all_mm2 += divided.bridges_mm2[i];
    for (const Vec3& corner_mm : divided.bridges_in_bone_mm[i]) {
      const double away_mm2 = squared_radius_mm2(joint, corner_mm);
      if (away_mm2 >= nearest_mm2) continue;
      nearest_mm2 = away_mm2;
      bridge_mm2 = divided.bridges_mm2[i];
    }
  }
  return all_mm2 - bridge_mm2 > weak_remnant_part * bridge_mm2;
}

}  // namespace

DividedBone divide_at_hinge(const CutSolid& solid, const Bvh& bvh, const KerfPlane& plane) {
  const KerfPlane middle{plane.bone_from_kerf, 0.0};
  const Section section = slice_section(solid, bvh, middle);
  const std::vector<std::uint8_t> all(section.regions.size(), 1);
  const CutSolid both = remove_slab(solid, bvh, section, hinge_face, all);
  const KerfAxes axes = axes_of(middle);
  const std::vector<bool> is_above = triangles_above(both.mesh, axes);
  DividedBone divided;
  divided.above = half_of(both, is_above, true);
  divided.below = half_of(both, is_above, false);
  for (const SectionRegion& region : section.regions) {
    divided.bridges_mm2.push_back(region.area_mm2);
    std::vector<Vec3>& corners_mm = divided.bridges_in_bone_mm.emplace_back();
    for (const Contour& contour : region.contours) {
      for (const Vec2& place : contour) {
        corners_mm.push_back(axes.origin_mm + place.x * axes.x + place.y * axes.y);
      }
    }
  }
  return divided;
}

ClosedHinge close_hinge(const CutSolid& solid, const Bvh& bvh, const HingeRequest& request) {
  const bool is_first_deeper = request.first_gap.thickness_mm <= request.second_gap.thickness_mm;
  const HingeGap& gap = is_first_deeper ? request.first_gap : request.second_gap;
  const KerfPlane& plane = is_first_deeper ? request.first : request.second;
  ClosedHinge closed;
  closed.thickness_mm = gap.thickness_mm;
  if (gap.thickness_mm < request.bridge.breaks_below_mm) {
    closed.outcome = HingeOutcome::Broken;
    return closed;
  }
  if (gap.thickness_mm > request.bridge.bends_up_to_mm) return closed;
  const KerfAxes axes = axes_of(plane);
  DividedBone divided = divide_at_hinge(solid, bvh, plane);
  closed.joint = joint_of(request, axes, gap.middle_in_bone_mm);
  if (is_held_elsewhere(divided, closed.joint)) return closed;
  // At the bridge's rim the halves share points; within a kerf of it their skins may pass each
  // other.
  closed.bridge_radius_mm = radius_around(closed.joint, divided) + plane.thickness_mm;
  const bool is_moved_above = glm::dot(axes.z, request.bridge.toward_moved) > 0.0;
  closed.moved = std::move(is_moved_above ? divided.above : divided.below);
  closed.fixed = std::move(is_moved_above ? divided.below : divided.above);
  const std::optional<TurnContact> contact =
      first_turn_contact(closed.fixed.mesh, closed.moved.mesh, closed.joint,
                         closed.bridge_radius_mm, request.most_rad);
  if (!contact) {
    closed.outcome = HingeOutcome::FacesMissing;
    return closed;
  }
  closed.outcome = HingeOutcome::Closed;
  closed.angle_rad = contact->angle_rad;
  closed.bone_from_moved = turn_about(closed.joint.point_mm, closed.joint.axis, contact->angle_rad);
  closed.contact_in_bone_mm = contact->point_mm;
  return closed;
}

}  // namespace hallux::simulator
