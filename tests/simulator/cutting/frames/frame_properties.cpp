#include "tests/simulator/cutting/frames/frame_properties.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "tests/simulator/cutting/worlds/outlines.h"

namespace hallux::tests {

using namespace simulator;

namespace {

/// The lattice's step, doubled for sections of more than 128 mm.
constexpr double step_mm = 2.0 / 1048576.0;

Vec3 place_of(const PlayedFrame& frame, std::uint32_t point) {
  const std::size_t count = frame.solid.mesh.points_mm.size();
  return point < count ? frame.solid.mesh.points_mm[point]
                       : frame.patch.points_in_bone_mm[point - count];
}

Vec3 doubled_normal(const std::array<Vec3, 3>& corners_mm) {
  return glm::cross(corners_mm[1] - corners_mm[0], corners_mm[2] - corners_mm[0]);
}

double longest_side_mm(const std::array<Vec3, 3>& corners_mm) {
  double longest2 = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 side_mm = corners_mm[(k + 1) % 3] - corners_mm[k];
    longest2 = std::max(longest2, glm::dot(side_mm, side_mm));
  }
  return std::sqrt(longest2);
}

std::array<Vec3, 3> corners_of(const PlayedFrame& frame, const Triangle& triangle) {
  return {place_of(frame, triangle[0]), place_of(frame, triangle[1]), place_of(frame, triangle[2])};
}

/// Whether a part lies on a triangle of the mesh and faces the way it does.
bool is_part_of(const std::array<Vec3, 3>& part_mm, const std::array<Vec3, 3>& whole_mm) {
  const Vec3 part = doubled_normal(part_mm), whole = doubled_normal(whole_mm);
  const double whole_length = std::sqrt(glm::dot(whole, whole));
  const double along = glm::dot(part, whole) / (std::sqrt(glm::dot(part, part)) * whole_length);
  const Vec3 middle_mm = (part_mm[0] + part_mm[1] + part_mm[2]) / 3.0;
  if (along < 1.0 - 1e-6) return false;
  if (std::abs(glm::dot(middle_mm - whole_mm[0], whole)) > 4.0 * step_mm * whole_length) {
    return false;
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 side_mm = whole_mm[(k + 1) % 3] - whole_mm[k];
    if (glm::dot(whole, glm::cross(side_mm, middle_mm - whole_mm[k])) < 0.0) return false;
  }
  return true;
}

bool is_wall(const PlayedFrame& frame, std::size_t triangle) {
  return frame.patch.sources[triangle].kerf == frame.kerf &&
         frame.patch.sources[triangle].side != 0;
}

/// The weights of a triangle's corners at a point on it.
std::array<double, 3> skin_weights(const IndexedMesh& mesh, std::uint32_t triangle,
                                   const Vec3& point_mm) {
  std::array<Vec3, 3> corners_mm;
  for (std::size_t k = 0; k < 3; ++k) {
    corners_mm[k] = mesh.points_mm[mesh.triangles[triangle][k]];
  }
  const Vec3 normal = glm::cross(corners_mm[1] - corners_mm[0], corners_mm[2] - corners_mm[0]);
  const double whole = glm::dot(normal, normal);
  if (whole == 0.0) return {1.0, 0.0, 0.0};
  std::array<double, 3> weights{};
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3& from_mm = corners_mm[(k + 1) % 3];
    const Vec3& to_mm = corners_mm[(k + 2) % 3];
    weights[k] = glm::dot(normal, glm::cross(to_mm - from_mm, point_mm - from_mm)) / whole;
  }
  return weights;
}

}  // namespace

bool has_walls_on_planes(const PlayedFrame& frame) {
  const double half_mm = 0.5 * frame.contact.plane.thickness_mm;
  for (std::size_t i = 0; i < frame.patch.triangles.size(); ++i) {
    if (!is_wall(frame, i)) continue;
    const double level_mm = frame.patch.sources[i].side * half_mm;
    for (const Vec3& corner_mm : corners_of(frame, frame.patch.triangles[i])) {
      if (std::abs(height_mm(frame.contact.axes, corner_mm) - level_mm) > 1e-9) return false;
    }
  }
  return true;
}

bool has_empty_kerf(const PlayedFrame& frame) {
  const double half_mm = 0.5 * frame.contact.plane.thickness_mm;
  std::set<std::uint32_t> points;
  for (const Triangle& corners : frame.patch.triangles) {
    points.insert(corners.begin(), corners.end());
  }
  return std::none_of(points.begin(), points.end(), [&](std::uint32_t point) {
    const Vec3 point_mm = place_of(frame, point);
    if (std::abs(height_mm(frame.contact.axes, point_mm)) > half_mm - 1e-9) return false;
    return is_well_inside(frame.region, place_mm(frame.contact.axes, point_mm), 4.0 * step_mm);
  });
}

bool keeps_skin(const PlayedFrame& frame) {
  for (std::size_t i = 0; i < frame.patch.triangles.size(); ++i) {
    if (frame.patch.sources[i].kerf == frame.kerf) continue;
    const std::array<Vec3, 3> part_mm = corners_of(frame, frame.patch.triangles[i]);
    const Vec3 normal = doubled_normal(part_mm);
    if (!(std::sqrt(glm::dot(normal, normal)) > 0.01 * longest_side_mm(part_mm))) continue;
    const bool is_found = std::any_of(
        frame.patch.hidden.begin(), frame.patch.hidden.end(), [&](std::uint32_t hidden) {
          return is_part_of(part_mm, corners_of(frame, frame.solid.mesh.triangles[hidden]));
        });
    if (!is_found) return false;
  }
  return true;
}

bool interpolates_skin(const PlayedFrame& frame) {
  for (std::size_t i = 0; i < frame.patch.points_in_bone_mm.size(); ++i) {
    const std::uint32_t parent = frame.patch.parents[i];
    if (parent == no_index) continue;
    const std::array<Vec3, 3> corners_mm = corners_of(frame, frame.solid.mesh.triangles[parent]);
    const Vec3 normal = doubled_normal(corners_mm);
    const double width_mm = std::sqrt(glm::dot(normal, normal)) / longest_side_mm(corners_mm);
    // No place has weights on a triangle that is a line.
    if (!(width_mm > 1e-3)) continue;
    const Vec3& point_mm = frame.patch.points_in_bone_mm[i];
    const std::array<double, 3> weights = skin_weights(frame.solid.mesh, parent, point_mm);
    Vec3 off_mm = -point_mm;
    for (std::size_t k = 0; k < 3; ++k) {
      off_mm += weights[k] * corners_mm[k];
      if (!(weights[k] > -4.0 * step_mm / width_mm)) return false;
    }
    if (!(std::sqrt(glm::dot(off_mm, off_mm)) < 8.0 * step_mm)) return false;
  }
  return true;
}

}  // namespace hallux::tests
