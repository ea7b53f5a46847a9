// From the kernel's solid to the card's buffers. A point becomes one vertex for each origin of its
// faces, so that an edge of a cut stays sharp and the skin smooth. The skin's triangles come first,
// then those of cuts, each in clusters of neighbours. A patch takes the look of the face it lies
// on, so that a growing kerf does not change what is beside it.
#include "ui/render/scene/bone_mesh.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "simulator/base/check.h"
#include "simulator/mesh/bvh.h"

namespace hallux::ui {

namespace {

using simulator::FaceSource;
using simulator::no_index;
using simulator::Triangle;

/// A skin that lies deeper than this below the outer surface is the canal's [mm].
constexpr double canal_depth_mm = 0.45;

std::int16_t short_of(double share) {
  return static_cast<std::int16_t>(std::lround(std::clamp(share, -1.0, 1.0) * 32767.0));
}

double share_of(std::int16_t value) { return static_cast<double>(value) / 32767.0; }

void set_normal(BoneVertex& vertex, const Vec3& direction) {
  const double length = glm::length(direction);
  const Vec3 unit = length > 0.0 ? direction / length : Vec3(0.0, 0.0, 1.0);
  vertex.normal = {short_of(unit.x), short_of(unit.y), short_of(unit.z)};
}

Vec3 normal_of(const BoneVertex& vertex) {
  return Vec3(share_of(vertex.normal[0]), share_of(vertex.normal[1]), share_of(vertex.normal[2]));
}

/// Points become vertices, one for each source of the faces around them.
class VertexTable {
 public:
  struct Entry {
    std::uint32_t point = 0;
    FaceSource face;
    Vec3 area_normal{0.0, 0.0, 0.0};  ///< sum over its faces, as long as twice their area
  };

  explicit VertexTable(std::size_t point_count) { vertices_.reserve(2 * point_count); }

  std::uint32_t vertex_of(std::uint32_t point, const FaceSource& source) {
    // A kerf's number and side below 2^30 and 2^2: one word with the point.
    const std::uint64_t face = 4U * static_cast<std::uint64_t>(source.kerf + 1) +
                               static_cast<std::uint64_t>(source.side + 1);
    const auto [at, is_new] =
        vertices_.try_emplace((face << 32U) | point, static_cast<std::uint32_t>(entries_.size()));
    if (is_new) entries_.push_back({point, source});
    return at->second;
  }
  std::vector<Entry>& entries() noexcept { return entries_; }

 private:
  std::unordered_map<std::uint64_t, std::uint32_t> vertices_;
  std::vector<Entry> entries_;
};

template <typename PointAt>
Triangle add_triangle(VertexTable& table, const Triangle& points, const FaceSource& source,
                      PointAt point_at) {
  const Vec3 first_mm = point_at(points[0]);
  const Vec3 area_normal =
      glm::cross(point_at(points[1]) - first_mm, point_at(points[2]) - first_mm);
  Triangle triangle{};
  for (std::size_t k = 0; k < 3; ++k) {
    triangle[k] = table.vertex_of(points[k], source);
    table.entries()[triangle[k]].area_normal += area_normal;
  }
  return triangle;
}

bool is_skin(const FaceSource& source, const Vec3& middle_mm, const DepthVolume& depth) {
  return source.kerf < 0 && depth_at(depth, middle_mm) < canal_depth_mm;
}

BoneVertex vertex_from(const VertexTable::Entry& entry, const Vec3& point_mm) {
  BoneVertex vertex;
  vertex.point_in_bone_mm = to_float(point_mm);
  set_normal(vertex, entry.area_normal);
  vertex.kerf = static_cast<std::int16_t>(entry.face.kerf);
  vertex.side = static_cast<std::int16_t>(entry.face.side);
  return vertex;
}

/// The canal's vertices are told by their depth; the skin's see as much light as their hollow lets
/// in.
void light_skin(BoneVertex& vertex, const DepthVolume& depth) {
  if (vertex.kerf >= 0) return;
  const Vec3 point_mm(vertex.point_in_bone_mm);
  if (depth_at(depth, point_mm) >= canal_depth_mm) {
    vertex.kerf = canal_kerf;
    return;
  }
  vertex.openness = short_of(openness_at(depth, point_mm, normal_of(vertex)));
}

Vec3 normal_of(const simulator::IndexedMesh& mesh, const Triangle& triangle) {
  const Vec3& first_mm = mesh.points_mm[triangle[0]];
  const Vec3 area =
      glm::cross(mesh.points_mm[triangle[1]] - first_mm, mesh.points_mm[triangle[2]] - first_mm);
  const double length = glm::length(area);
  return length > 0.0 ? area / length : Vec3(0.0);
}

/// Of the solid's triangles with these numbers, which are drawn after each other.
TriangleCluster cluster_of(const simulator::IndexedMesh& solid,
                           std::span<const std::uint32_t> numbers, std::size_t first) {
  TriangleCluster cluster{
      {static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(numbers.size())}, {}, {}};
  std::vector<Vec3> normals;
  normals.reserve(numbers.size());
  for (const std::uint32_t i : numbers) {
    for (const std::uint32_t point : solid.triangles[i]) cluster.box.add(solid.points_mm[point]);
    normals.push_back(normal_of(solid, solid.triangles[i]));
  }
  cluster.normals = cone_around(normals);
  return cluster;
}

/// Adds the triangles that are picked, neighbours after each other.
std::vector<TriangleCluster> add_clustered(BoneMesh& mesh, const std::vector<Triangle>& triangles,
                                           std::span<const std::uint32_t> picked) {
  const simulator::IndexedMesh& solid = mesh.solid.mesh;
  std::vector<Vec3> middles_mm;
  middles_mm.reserve(picked.size());
  for (const std::uint32_t i : picked)
    middles_mm.push_back(simulator::middle_of(corners_of(solid, i)));
  std::vector<std::uint32_t> ordered = order_by_place(middles_mm);
  for (std::uint32_t& number : ordered) number = picked[number];
  std::vector<TriangleCluster> clusters;
  const std::span<const std::uint32_t> all(ordered);
  for (std::size_t first = 0; first < all.size(); first += cluster_triangles) {
    const std::size_t count = std::min<std::size_t>(cluster_triangles, all.size() - first);
    clusters.push_back(cluster_of(solid, all.subspan(first, count), mesh.triangles.size()));
    for (const std::uint32_t i : all.subspan(first, count)) {
      mesh.place_of[i] = static_cast<std::uint32_t>(mesh.triangles.size());
      mesh.triangles.push_back(triangles[i]);
    }
  }
  return clusters;
}

/// The skin's triangles first.
void sort_by_kind(BoneMesh& mesh, const std::vector<Triangle>& triangles, const BoneLook& look) {
  const simulator::IndexedMesh& solid = mesh.solid.mesh;
  std::vector<std::uint32_t> skin, others;
  for (std::uint32_t i = 0; i < triangles.size(); ++i) {
    const Vec3 middle_mm = simulator::middle_of(corners_of(solid, i));
    (is_skin(mesh.solid.sources[i], middle_mm, look.depth) ? skin : others).push_back(i);
  }
  mesh.place_of.resize(triangles.size());
  mesh.triangles.reserve(triangles.size());
  mesh.skin_clusters = add_clustered(mesh, triangles, skin);
  mesh.skin_count = mesh.triangles.size();
  mesh.cut_clusters = add_clustered(mesh, triangles, others);
}

/// The weights of a triangle's corners at a point on it.
std::array<double, 3> weights_at(const std::array<Vec3, 3>& corners, const Vec3& point) {
  const Vec3 along = corners[1] - corners[0], across = corners[2] - corners[0];
  const Vec3 to_point = point - corners[0];
  const double aa = glm::dot(along, along), ac = glm::dot(along, across),
               cc = glm::dot(across, across);
  const double pa = glm::dot(to_point, along), pc = glm::dot(to_point, across);
  const double area = aa * cc - ac * ac;
  if (area <= 0.0) return {1.0, 0.0, 0.0};
  const double b = std::clamp((cc * pa - ac * pc) / area, 0.0, 1.0);
  const double c = std::clamp((aa * pc - ac * pa) / area, 0.0, 1.0 - b);
  return {1.0 - b - c, b, c};
}

/// What a point of the patch takes over from the face on which it lies.
void take_from_parent(BoneVertex& vertex, const BoneMesh& mesh, std::uint32_t parent) {
  const Triangle& triangle = mesh.triangles[mesh.place_of[parent]];
  std::array<Vec3, 3> corners{};
  for (std::size_t k = 0; k < 3; ++k) {
    corners[k] = Vec3(mesh.vertices[triangle[k]].point_in_bone_mm);
  }
  const auto weights = weights_at(corners, Vec3(vertex.point_in_bone_mm));
  Vec3 normal(0.0);
  double openness = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    normal += weights[k] * normal_of(mesh.vertices[triangle[k]]);
    openness += weights[k] * share_of(mesh.vertices[triangle[k]].openness);
  }
  set_normal(vertex, normal);
  vertex.openness = short_of(openness);
  vertex.kerf = mesh.vertices[triangle[0]].kerf;
}

/// A vertex of the patch: a point of the mesh as it is there, a new point as its parent, else by
/// its own faces.
BoneVertex patch_vertex(const BoneMesh& mesh, const simulator::SolidPatch& patch,
                        const VertexTable::Entry& entry) {
  const auto base_count = static_cast<std::uint32_t>(mesh.solid.mesh.points_mm.size());
  const bool is_of_mesh = entry.point < base_count;
  if (is_of_mesh && entry.face.kerf < 0) {
    const std::uint32_t same = mesh.skin_vertex_of[entry.point];
    if (same != no_index) return mesh.vertices[same];
  }
  const Vec3& point_mm = is_of_mesh ? mesh.solid.mesh.points_mm[entry.point]
                                    : patch.points_in_bone_mm[entry.point - base_count];
  BoneVertex vertex = vertex_from(entry, point_mm);
  vertex.openness = 0;
  if (is_of_mesh) return vertex;
  const std::uint32_t parent = patch.parents[entry.point - base_count];
  if (parent != no_index && mesh.solid.sources[parent] == entry.face) {
    take_from_parent(vertex, mesh, parent);
  }
  return vertex;
}

}  // namespace

BoneMesh mesh_of(std::uint64_t id, const simulator::CutSolid& solid, const BoneLook& look) {
  CHECK(id != 0 && solid.sources.size() == solid.mesh.triangles.size());
  BoneMesh made;
  made.id = id;
  made.solid = solid;
  const auto point_at = [&](std::uint32_t point) { return solid.mesh.points_mm[point]; };
  VertexTable table(solid.mesh.points_mm.size());
  std::vector<Triangle> triangles;
  triangles.reserve(solid.mesh.triangles.size());
  for (std::size_t i = 0; i < solid.mesh.triangles.size(); ++i) {
    triangles.push_back(add_triangle(table, solid.mesh.triangles[i], solid.sources[i], point_at));
  }
  made.skin_vertex_of.assign(solid.mesh.points_mm.size(), no_index);
  for (const VertexTable::Entry& entry : table.entries()) {
    if (entry.face.kerf < 0) {
      made.skin_vertex_of[entry.point] = static_cast<std::uint32_t>(made.vertices.size());
    }
    made.vertices.push_back(vertex_from(entry, point_at(entry.point)));
    light_skin(made.vertices.back(), look.depth);
  }
  sort_by_kind(made, triangles, look);
  made.low_mm = Vec3(1e300);
  made.high_mm = Vec3(-1e300);
  for (const Vec3& point_mm : solid.mesh.points_mm) {
    made.low_mm = glm::min(made.low_mm, point_mm);
    made.high_mm = glm::max(made.high_mm, point_mm);
  }
  return made;
}

void make_patch_mesh(const BoneMesh& mesh, const simulator::SolidPatch& patch, PatchMesh& made) {
  const auto base_count = static_cast<std::uint32_t>(mesh.solid.mesh.points_mm.size());
  const auto point_at = [&](std::uint32_t point) {
    return point < base_count ? mesh.solid.mesh.points_mm[point]
                              : patch.points_in_bone_mm[point - base_count];
  };
  VertexTable table(patch.points_in_bone_mm.size());
  std::vector<Triangle> others;
  made.triangles.clear();
  made.vertices.clear();
  std::vector<Triangle> all;
  all.reserve(patch.triangles.size());
  for (std::size_t i = 0; i < patch.triangles.size(); ++i) {
    all.push_back(add_triangle(table, patch.triangles[i], patch.sources[i], point_at));
  }
  for (const VertexTable::Entry& entry : table.entries()) {
    made.vertices.push_back(patch_vertex(mesh, patch, entry));
  }
  for (const Triangle& triangle : all) {
    const bool is_of_skin = made.vertices[triangle[0]].kerf == -1;
    (is_of_skin ? made.triangles : others).push_back(triangle);
  }
  made.skin_count = made.triangles.size();
  made.triangles.insert(made.triangles.end(), others.begin(), others.end());
}

BoneMesh lit_mesh_of(std::uint64_t id, const simulator::CutSolid& solid, const BoneLook& look) {
  BoneMesh mesh = mesh_of(id, solid, look);
  const simulator::Bvh tree(solid.mesh);
  const Occluder own{&tree, {}};
  light_cut_faces(mesh, std::span(&own, 1));
  return mesh;
}

void light_cut_faces(BoneMesh& mesh, std::span<const Occluder> occluders) {
  constexpr double near_mm = 0.4, far_mm = 6.0, lift_mm = 0.02;
  std::vector<Vec3> inward_mm(mesh.vertices.size(), Vec3(0.0));
  for (std::size_t i = mesh.skin_count; i < mesh.triangles.size(); ++i) {
    const Triangle& triangle = mesh.triangles[i];
    Vec3 middle_mm(0.0);
    for (const std::uint32_t corner : triangle) {
      middle_mm += Vec3(mesh.vertices[corner].point_in_bone_mm) / 3.0;
    }
    for (const std::uint32_t corner : triangle) inward_mm[corner] = middle_mm;
  }
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    BoneVertex& vertex = mesh.vertices[i];
    if (vertex.kerf < 0) continue;
    // A vertex lies on the rim, where a ray just grazes the other wall: it is asked a little
    // further inside.
    const Vec3 rim_mm(vertex.point_in_bone_mm), normal = normal_of(vertex);
    const Vec3 start_mm = rim_mm + 0.05 * (inward_mm[i] - rim_mm) + lift_mm * normal;
    double free_mm = far_mm;
    for (const Occluder& other : occluders) {
      const RigidTransform other_from_body = inverse(other.body_from_other);
      const auto hit = other.bvh->first_hit(transform_point(other_from_body, start_mm),
                                            transform_direction(other_from_body, normal));
      if (hit) free_mm = std::min(free_mm, hit->distance_mm);
    }
    const double share = std::clamp((free_mm - near_mm) / (far_mm - near_mm), 0.0, 1.0);
    vertex.openness = short_of(share * (2.0 - share));
  }
}

}  // namespace hallux::ui
