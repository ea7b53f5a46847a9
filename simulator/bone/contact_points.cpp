#include "simulator/bone/contact_points.h"

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

namespace hallux::simulator {

namespace {

constexpr std::size_t wall_part = 3, all_parts = 4;
/// Directions that cancel to less than this part of their sum say nothing.
constexpr double least_part = 0.2;

/// Corners of one face of the solid, each once.
using Corners = std::vector<std::uint32_t>;

struct Faces {
  /// By kerf and side.
  std::map<std::pair<std::int32_t, std::int32_t>, Corners> walls;
  Corners skin;
};

void make_unique(Corners& corners) {
  std::sort(corners.begin(), corners.end());
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
}

Faces faces_of(const CutSolid& solid) {
  Faces faces;
  for (std::size_t i = 0; i < solid.mesh.triangles.size(); ++i) {
    const FaceSource& source = solid.sources[i];
    Corners& corners = source.kerf == -1 ? faces.skin : faces.walls[{source.kerf, source.side}];
    corners.insert(corners.end(), solid.mesh.triangles[i].begin(), solid.mesh.triangles[i].end());
  }
  make_unique(faces.skin);
  for (auto& [source, corners] : faces.walls) make_unique(corners);
  return faces;
}

/// Adds the corner that lies furthest from those before it, again and again, begun with the one
/// furthest from the middle.
void spread(const IndexedMesh& mesh, const Corners& corners, std::size_t count,
            std::vector<Vec3>& points_mm) {
  Vec3 middle{0.0, 0.0, 0.0};
  for (const std::uint32_t corner : corners) middle += mesh.points_mm[corner];
  middle /= static_cast<double>(corners.size());
  std::vector<double> away_mm2;
  for (const std::uint32_t corner : corners)
    away_mm2.push_back(squared_length(mesh.points_mm[corner] - middle));
  for (std::size_t added = 0; added < std::min(count, corners.size()); ++added) {
    const auto furthest = std::max_element(away_mm2.begin(), away_mm2.end());
    const auto place = static_cast<std::size_t>(furthest - away_mm2.begin());
    const Vec3 point = mesh.points_mm[corners[place]];
    points_mm.push_back(point);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const double to_point_mm2 = squared_length(mesh.points_mm[corners[i]] - point);
      away_mm2[i] = added == 0 ? to_point_mm2 : std::min(away_mm2[i], to_point_mm2);
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
  const Faces faces = faces_of(solid);
  if (!faces.walls.empty()) {
    const std::size_t of_each =
        std::max<std::size_t>(1, most * wall_part / all_parts / faces.walls.size());
    for (const auto& [source, corners] : faces.walls) {
      if (points_mm.size() + of_each > most) break;
      spread(solid.mesh, corners, of_each, points_mm);
    }
  }
  if (!faces.skin.empty()) spread(solid.mesh, faces.skin, most - points_mm.size(), points_mm);
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
