#include "simulator/mesh/surface_normals.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "simulator/base/elementary.h"
#include "simulator/mesh/edge_pairs.h"

namespace hallux::simulator {

namespace {

/// Where cuts meet at small angles, corners are known to no more than this: a triangle that is
/// thinner may lie the wrong way round.
constexpr double sliver_mm = 1.0e-5;

Vec3 unit_normal_of(const std::array<Vec3, 3>& corner_mm) noexcept {
  const Vec3 ab = corner_mm[1] - corner_mm[0];
  const Vec3 ac = corner_mm[2] - corner_mm[0];
  const Vec3 bc = corner_mm[2] - corner_mm[1];
  const Vec3 normal = glm::cross(ab, ac);
  const double longest_mm2 = std::max({squared_length(ab), squared_length(ac), squared_length(bc)});
  const double length = length_of(normal);
  if (!(length > sliver_mm * std::sqrt(longest_mm2))) return Vec3{0.0, 0.0, 0.0};
  return normal / length;
}

double angle_rad(const Vec3& a, const Vec3& b) noexcept {
  return elementary::atan2(length_of(glm::cross(a, b)), glm::dot(a, b));
}

bool is_zero(const Vec3& value) noexcept { return value == Vec3{0.0, 0.0, 0.0}; }

std::vector<Vec3> point_normals(const IndexedMesh& mesh, const std::vector<Vec3>& unit_normal) {
  std::vector<Vec3> normals(mesh.points_mm.size(), Vec3{0.0, 0.0, 0.0});
  std::vector<bool> touches_sliver(mesh.points_mm.size(), false);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const Triangle& triangle = mesh.triangles[i];
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& corner = mesh.points_mm[triangle[k]];
      const Vec3 to_next = mesh.points_mm[triangle[(k + 1) % 3]] - corner;
      const Vec3 to_last = mesh.points_mm[triangle[(k + 2) % 3]] - corner;
      normals[triangle[k]] += angle_rad(to_next, to_last) * unit_normal[i];
      if (is_zero(unit_normal[i])) touches_sliver[triangle[k]] = true;
    }
  }
  for (std::size_t i = 0; i < normals.size(); ++i) {
    if (touches_sliver[i]) normals[i] = Vec3{0.0, 0.0, 0.0};
  }
  return normals;
}

}  // namespace

SurfaceNormals::SurfaceNormals(const IndexedMesh& mesh)
    : triangles_(mesh.triangles), opposite_(pair_edges(mesh).opposite) {
  unit_normal_.reserve(mesh.triangles.size());
  for (const Triangle& triangle : mesh.triangles) {
    unit_normal_.push_back(unit_normal_of(
        {mesh.points_mm[triangle[0]], mesh.points_mm[triangle[1]], mesh.points_mm[triangle[2]]}));
  }
  point_normal_ = point_normals(mesh, unit_normal_);
}

bool SurfaceNormals::is_sliver(std::uint32_t triangle) const noexcept {
  return is_zero(unit_normal_[triangle]);
}

Vec3 SurfaceNormals::at(std::uint32_t triangle, const ClosestPoint& closest) const noexcept {
  const Vec3& own = unit_normal_[triangle];
  switch (closest.part) {
    case TrianglePart::Corner:
      return point_normal_[triangles_[triangle][closest.index]];
    case TrianglePart::Edge: {
      const std::uint32_t opposite =
          opposite_[3 * triangle + static_cast<std::uint32_t>(closest.index)];
      if (opposite == no_half_edge || is_zero(own) || is_sliver(opposite / 3)) return Vec3{0.0};
      return own + unit_normal_[opposite / 3];
    }
    case TrianglePart::Face:
      break;
  }
  return own;
}

}  // namespace hallux::simulator
