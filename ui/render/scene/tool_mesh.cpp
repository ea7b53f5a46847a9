// Two ways to a normal: a part turned about an axis has those of its outline, every other surface
// the mean of the faces around a point that no edge parts. A point has as many vertices as it has
// normals and materials.
#include "ui/render/scene/tool_mesh.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include "simulator/base/check.h"
#include "simulator/base/units.h"

namespace hallux::ui {

namespace {

using simulator::IndexedMesh;
using simulator::Triangle;

/// Points nearer to each other are one.
constexpr double weld_mm = 1.0e-5;

Vec2 outward(const ProfilePoint& from, const ProfilePoint& to) {
  return glm::normalize(Vec2(from.radius_mm - to.radius_mm, to.along_mm - from.along_mm));
}

/// The outline's normal at an end of piece `i`: shared with the neighbour unless there is an edge
/// between them.
Vec2 outline_normal(std::span<const ProfilePoint> profile, std::size_t i, bool at_end) {
  constexpr double smooth_below = 0.78;  // cosine: about 39 degrees
  const Vec2 own = outward(profile[i], profile[i + 1]);
  const std::size_t other = at_end ? i + 1 : i - 1;
  if ((!at_end && i == 0) || other + 1 >= profile.size()) return own;
  const Vec2 next = outward(profile[other], profile[other + 1]);
  return glm::dot(own, next) < smooth_below ? own : glm::normalize(own + next);
}

/// For each point the first one that lies in its place.
std::vector<std::uint32_t> welded(const std::vector<Vec3>& points_mm) {
  std::map<std::array<long, 3>, std::uint32_t> first;
  std::vector<std::uint32_t> names;
  for (const Vec3& point_mm : points_mm) {
    const auto cell = [&](double at) { return std::lround(at / weld_mm); };
    const auto next = static_cast<std::uint32_t>(names.size());
    const std::array<long, 3> place{cell(point_mm.x), cell(point_mm.y), cell(point_mm.z)};
    names.push_back(first.try_emplace(place, next).first->second);
  }
  return names;
}

/// A corner of a face at a point.
struct Corner {
  std::size_t face = 0;
  double angle_rad = 0.0;
};

double angle_at(const std::array<Vec3, 3>& corners_mm, std::size_t corner) {
  const Vec3 to_next = glm::normalize(corners_mm[(corner + 1) % 3] - corners_mm[corner]);
  const Vec3 to_last = glm::normalize(corners_mm[(corner + 2) % 3] - corners_mm[corner]);
  return std::acos(std::clamp(glm::dot(to_next, to_last), -1.0, 1.0));
}

/// A surface's faces that have an area, with what meets at each point.
struct Faces {
  std::vector<Triangle> triangles;
  std::vector<Vec3> normals;
  /// Its number in the surface.
  std::vector<std::size_t> numbers;
  std::vector<std::vector<Corner>> around;
};

Faces faces_of(const IndexedMesh& surface) {
  const std::vector<std::uint32_t> names = welded(surface.points_mm);
  Faces faces;
  faces.around.resize(names.size());
  for (std::size_t number = 0; number < surface.triangles.size(); ++number) {
    Triangle triangle = surface.triangles[number];
    for (std::uint32_t& corner : triangle) corner = names[corner];
    if (triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0])
      continue;
    const std::array<Vec3, 3> corners_mm{surface.points_mm[triangle[0]],
                                         surface.points_mm[triangle[1]],
                                         surface.points_mm[triangle[2]]};
    const Vec3 normal = glm::cross(corners_mm[1] - corners_mm[0], corners_mm[2] - corners_mm[0]);
    const double length = glm::length(normal);
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const double angle_rad = length > 0.0 ? angle_at(corners_mm, corner) : 0.0;
      faces.around[triangle[corner]].push_back({faces.triangles.size(), angle_rad});
    }
    faces.triangles.push_back(triangle);
    faces.normals.push_back(length > 0.0 ? normal / length : Vec3(0.0));
    faces.numbers.push_back(number);
  }
  return faces;
}

/// Of one face's corner at that point: the mean of the faces there to which it is smooth.
Vec3 smooth_normal(const Faces& faces, std::size_t face, std::uint32_t point,
                   const std::function<bool(std::size_t)>& is_smooth_to) {
  Vec3 sum(0.0);
  for (const Corner& corner : faces.around[point]) {
    if (is_smooth_to(corner.face)) sum += corner.angle_rad * faces.normals[corner.face];
  }
  const double length = glm::length(sum);
  if (length > 0.0) return sum / length;
  // A face without an area, which nobody sees.
  return faces.normals[face] == Vec3(0.0) ? Vec3(1.0, 0.0, 0.0) : faces.normals[face];
}

Vec3 middle_of(const ToolRing& ring) {
  Vec3 sum(0.0);
  for (const Vec3& point_mm : ring.points_mm) sum += point_mm;
  return sum / static_cast<double>(ring.points_mm.size());
}

}  // namespace

void ToolBuilder::add_vertex(const Vec3& point_mm, const Vec3& normal, ToolMaterial material) {
  mesh_.vertices.push_back({to_float(point_mm), to_float(normal), static_cast<float>(material)});
}

void ToolBuilder::add_triangle(const std::array<Vec3, 3>& corners_mm, ToolMaterial material) {
  const Vec3 normal =
      glm::normalize(glm::cross(corners_mm[1] - corners_mm[0], corners_mm[2] - corners_mm[0]));
  const auto first = static_cast<std::uint32_t>(mesh_.vertices.size());
  for (const Vec3& corner_mm : corners_mm) add_vertex(corner_mm, normal, material);
  mesh_.triangles.push_back({first, first + 1, first + 2});
}

void ToolBuilder::add_quad(const std::array<Vec3, 4>& corners_mm, ToolMaterial material) {
  add_triangle({corners_mm[0], corners_mm[1], corners_mm[2]}, material);
  add_triangle({corners_mm[0], corners_mm[2], corners_mm[3]}, material);
}

void ToolBuilder::add_turned(std::span<const ProfilePoint> profile,
                             const RigidTransform& tool_from_turned) {
  constexpr std::uint32_t segments = 40;
  for (std::size_t i = 0; i + 1 < profile.size(); ++i) {
    const auto first = static_cast<std::uint32_t>(mesh_.vertices.size());
    const std::array<Vec2, 2> normals{outline_normal(profile, i, false),
                                      outline_normal(profile, i, true)};
    for (std::uint32_t s = 0; s <= segments; ++s) {
      const double angle = 2.0 * pi * s / segments;
      const Vec3 away(std::cos(angle), std::sin(angle), 0.0);
      for (std::size_t end = 0; end < 2; ++end) {
        const ProfilePoint& point = profile[i + end];
        const Vec3 place_mm = point.radius_mm * away + Vec3(0.0, 0.0, point.along_mm);
        const Vec3 normal = normals[end].y * away + Vec3(0.0, 0.0, normals[end].x);
        add_vertex(transform_point(tool_from_turned, place_mm),
                   transform_direction(tool_from_turned, normal), profile[i].material);
      }
    }
    for (std::uint32_t s = 0; s < segments; ++s) {
      const std::uint32_t a = first + 2 * s;
      mesh_.triangles.push_back({a, a + 2, a + 3});
      mesh_.triangles.push_back({a, a + 3, a + 1});
    }
  }
}

void ToolBuilder::add_faces(const IndexedMesh& surface, std::span<const FaceKind> kinds,
                            double edge_rad) {
  const Faces faces = faces_of(surface);
  const double least_cosine = std::cos(edge_rad);
  const auto kind_of = [&](std::size_t face) { return kinds[faces.numbers[face]]; };
  /// Of each point the vertices that it has already.
  std::vector<std::vector<std::uint32_t>> made(surface.points_mm.size());
  for (std::size_t face = 0; face < faces.triangles.size(); ++face) {
    const FaceKind kind = kind_of(face);
    const auto is_smooth_to = [&](std::size_t other) {
      return kind_of(other).surface == kind.surface &&
             glm::dot(faces.normals[other], faces.normals[face]) >= least_cosine;
    };
    Triangle triangle{};
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const std::uint32_t point = faces.triangles[face][corner];
      const Vec3 normal = smooth_normal(faces, face, point, is_smooth_to);
      const auto is_it = [&](std::uint32_t vertex) {
        const ToolVertex& other = mesh_.vertices[vertex];
        return other.material == static_cast<float>(kind.material) &&
               glm::dot(Vec3(other.normal), normal) > 0.99999;
      };
      const auto found = std::ranges::find_if(made[point], is_it);
      triangle[corner] =
          found != made[point].end() ? *found : static_cast<std::uint32_t>(mesh_.vertices.size());
      if (found != made[point].end()) continue;
      made[point].push_back(triangle[corner]);
      add_vertex(surface.points_mm[point], normal, kind.material);
    }
    mesh_.triangles.push_back(triangle);
  }
}

void ToolBuilder::add_surface(const IndexedMesh& surface, ToolMaterial material, double edge_rad) {
  add_faces(surface, std::vector(surface.triangles.size(), FaceKind{material, 0}), edge_rad);
}

void ToolBuilder::add_rings(std::span<const ToolRing> rings, double edge_rad,
                            std::span<const int> surfaces) {
  CHECK(!rings.empty());
  const auto count = static_cast<std::uint32_t>(rings.front().points_mm.size());
  IndexedMesh surface;
  std::vector<FaceKind> kinds;
  for (const ToolRing& ring : rings) {
    CHECK(ring.points_mm.size() == count);
    surface.points_mm.insert(surface.points_mm.end(), ring.points_mm.begin(), ring.points_mm.end());
  }
  const auto last = static_cast<std::uint32_t>(rings.size() - 1) * count;
  const auto ends = static_cast<std::uint32_t>(surface.points_mm.size());
  surface.points_mm.push_back(middle_of(rings.front()));
  surface.points_mm.push_back(middle_of(rings.back()));
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t next = (i + 1) % count;
    const auto add = [&](const Triangle& triangle, ToolMaterial material) {
      surface.triangles.push_back(triangle);
      kinds.push_back({material, surfaces.empty() ? 0 : surfaces[i]});
    };
    add({ends, next, i}, rings.front().material);
    for (std::uint32_t ring = 0; ring < last; ring += count) {
      const ToolMaterial material = rings[ring / count].material;
      add({ring + i, ring + next, ring + count + next}, material);
      add({ring + i, ring + count + next, ring + count + i}, material);
    }
    add({ends + 1, last + i, last + next}, rings.back().material);
  }
  add_faces(surface, kinds, edge_rad);
}

ToolRing ring_around_x(double x_mm, std::span<const Vec2> points_yz_mm, ToolMaterial material) {
  ToolRing ring{{}, material};
  for (const Vec2& point_mm : points_yz_mm) ring.points_mm.emplace_back(x_mm, point_mm);
  return ring;
}

ToolRing circle_around_x(double x_mm, double radius_mm, std::uint32_t count,
                         ToolMaterial material) {
  ToolRing ring{{}, material};
  for (std::uint32_t i = 0; i < count; ++i) {
    const double angle_rad = 2.0 * pi * i / count;
    ring.points_mm.emplace_back(x_mm, radius_mm * std::cos(angle_rad),
                                radius_mm * std::sin(angle_rad));
  }
  return ring;
}

ToolMesh mirrored_in_y(const ToolMesh& mesh) {
  ToolMesh mirrored = mesh;
  for (ToolVertex& vertex : mirrored.vertices) {
    vertex.point_in_tool_mm.y = -vertex.point_in_tool_mm.y;
    vertex.normal.y = -vertex.normal.y;
  }
  for (Triangle& triangle : mirrored.triangles) std::swap(triangle[1], triangle[2]);
  return mirrored;
}

}  // namespace hallux::ui
