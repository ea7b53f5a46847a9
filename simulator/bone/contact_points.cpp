#include "simulator/bone/contact_points.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

namespace hallux::simulator {

namespace {

/// Of all points: of rims, and of those where three faces meet.
constexpr std::size_t rim_part = 3, tip_part = 1, all_parts = 4;
/// One in so many is among the foremost.
constexpr std::size_t foremost_part = 4;
/// Directions that cancel to less than this part of their sum say nothing.
constexpr double least_part = 0.2;

/// Corners of the mesh, each once.
using Corners = std::vector<std::uint32_t>;

struct Rims {
  /// Where a wall ends: at another one, or at the skin; and of those where three faces meet.
  Corners along, tips;
  /// Within the skin.
  Corners skin;
};

/// The different faces of the solid on which a corner lies, as many as are told apart.
struct FacesOfCorner {
  std::array<FaceSource, 3> faces;
  std::size_t count = 0;

  void add(const FaceSource& face) {
    const auto end = faces.begin() + static_cast<std::ptrdiff_t>(count);
    if (count < faces.size() && std::find(faces.begin(), end, face) == end) faces[count++] = face;
  }
};

Rims rims_of(const CutSolid& solid) {
  std::vector<FacesOfCorner> corners(solid.mesh.points_mm.size());
  for (std::size_t i = 0; i < solid.mesh.triangles.size(); ++i)
    for (const std::uint32_t corner : solid.mesh.triangles[i])
      corners[corner].add(solid.sources[i]);
  Rims rims;
  for (std::uint32_t corner = 0; corner < corners.size(); ++corner) {
    const FacesOfCorner& of = corners[corner];
    if (of.count > 1) rims.along.push_back(corner);
    if (of.count > 2) rims.tips.push_back(corner);
    if (of.count == 1 && of.faces[0].kerf == -1) rims.skin.push_back(corner);
  }
  return rims;
}

/// To the nearest of the points; where there are none yet, to the middle of the corners.
std::vector<double> squared_ways(const IndexedMesh& mesh, const Corners& corners,
                                 const std::vector<Vec3>& points_mm) {
  Vec3 middle{0.0, 0.0, 0.0};
  for (const std::uint32_t corner : corners) middle += mesh.points_mm[corner];
  const std::vector<Vec3> only_middle{middle / static_cast<double>(corners.size())};
  std::vector<double> away_mm2;
  for (const std::uint32_t corner : corners) {
    double least_mm2 = std::numeric_limits<double>::infinity();
    for (const Vec3& point : points_mm.empty() ? only_middle : points_mm)
      least_mm2 = std::min(least_mm2, squared_length(mesh.points_mm[corner] - point));
    away_mm2.push_back(least_mm2);
  }
  return away_mm2;
}

/// Adds the corner that lies furthest from all points that there are, again and again until there
/// are so many, or every corner is one.
void spread(const IndexedMesh& mesh, const Corners& corners, std::size_t count,
            std::vector<Vec3>& points_mm) {
  if (corners.empty()) return;
  std::vector<double> away_mm2 = squared_ways(mesh, corners, points_mm);
  while (points_mm.size() < count) {
    const auto furthest = std::max_element(away_mm2.begin(), away_mm2.end());
    if (!(*furthest > 0.0)) return;
    const Vec3 point =
        mesh.points_mm[corners[static_cast<std::size_t>(furthest - away_mm2.begin())]];
    const bool is_first = points_mm.empty();
    points_mm.push_back(point);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const double to_point_mm2 = squared_length(mesh.points_mm[corners[i]] - point);
      away_mm2[i] = is_first ? to_point_mm2 : std::min(away_mm2[i], to_point_mm2);
    }
  }
}

/// Further away nothing is faced: more than any kerf is wide.
constexpr double facing_mm = 1.5;

bool faces_any(const Vec3& point_mm, const Vec3& normal, std::span<const Bvh* const> others) {
  return std::any_of(others.begin(), others.end(), [&](const Bvh* other) {
    const auto near = other->nearest(point_mm, facing_mm);
    return near && glm::dot(near->point_mm - point_mm, normal) > 0.0;
  });
}

}  // namespace

std::vector<Vec3> contact_points(const CutSolid& solid, std::size_t most) {
  std::vector<Vec3> points_mm;
  const Rims rims = rims_of(solid);
  const auto add = [&](std::size_t from, std::size_t to) {
    spread(solid.mesh, rims.tips, from + (to - from) * tip_part / all_parts, points_mm);
    spread(solid.mesh, rims.along, from + (to - from) * rim_part / all_parts, points_mm);
    spread(solid.mesh, rims.skin, to, points_mm);
    // Where there is little skin.
    spread(solid.mesh, rims.along, to, points_mm);
  };
  add(0, most / foremost_part);
  add(most / foremost_part, most);
  return points_mm;
}

Vec3 out_of_facing_walls(const CutSolid& solid, std::span<const Bvh* const> others) {
  Vec3 sum{0.0, 0.0, 0.0};
  double size = 0.0;
  for (std::size_t i = 0; i < solid.mesh.triangles.size(); ++i) {
    if (solid.sources[i].kerf == -1) continue;
    const std::array<Vec3, 3> at = corners_of(solid.mesh, i);
    const Vec3 doubled_area = glm::cross(at[1] - at[0], at[2] - at[0]);
    if (!faces_any((at[0] + at[1] + at[2]) / 3.0, doubled_area, others)) continue;
    sum += doubled_area;
    size += length_of(doubled_area);
  }
  const double length = length_of(sum);
  return length > least_part * size ? sum / length : Vec3{0.0, 0.0, 0.0};
}

Vec3 centroid_of(const IndexedMesh& mesh) {
  Vec3 sum{0.0, 0.0, 0.0};
  double volume = 0.0;
  // About a corner of the mesh: far from the origin little of a sum would be left.
  const Vec3 origin = mesh.points_mm.front();
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const std::array<Vec3, 3> at = corners_of(mesh, i);
    const Vec3 a = at[0] - origin, b = at[1] - origin, c = at[2] - origin;
    const double part = glm::dot(a, glm::cross(b, c));
    sum += part * (a + b + c);
    volume += part;
  }
  return volume > 0.0 ? origin + sum / (4.0 * volume) : origin;
}

}  // namespace hallux::simulator
