#include "simulator/cutting/solid/working_solid.h"

#include <algorithm>
#include <cmath>

#include "simulator/base/check.h"

namespace hallux::simulator {

using OpenMesh::FaceHandle;
using OpenMesh::VertexHandle;

namespace {

/// A weight below this is rounding: the point lies on the side opposite that corner.
constexpr double side_weight = 1.0e-9;

FaceHandle face_handle(std::size_t index) { return FaceHandle(static_cast<int>(index)); }
VertexHandle vertex_handle(std::size_t index) { return VertexHandle(static_cast<int>(index)); }

Vec3 place_of(const HalfEdgeMesh& mesh, VertexHandle vertex) {
  const OpenMesh::Vec3d& point = mesh.point(vertex);
  return {point[0], point[1], point[2]};
}

/// From the corner that the triangle began with.
std::array<VertexHandle, 3> corners_of(const HalfEdgeMesh& mesh, FaceHandle face) {
  const auto last = mesh.halfedge_handle(face);
  const auto first = mesh.next_halfedge_handle(last);
  return {mesh.to_vertex_handle(last), mesh.to_vertex_handle(first),
          mesh.to_vertex_handle(mesh.next_halfedge_handle(first))};
}

Vec3 unit(const Vec3& direction) noexcept {
  const double length = std::sqrt(glm::dot(direction, direction));
  return length > 0.0 ? direction / length : direction;
}

/// Weights that give a point back nearer than this are sound [mm].
constexpr double sound_mm = 1.0e-9;

/// skin_weights, or where a triangle has hardly any area and they say nothing, the shares of its longest side.
std::array<double, 3> sound_weights(const IndexedMesh& mesh, std::uint32_t triangle,
                                    const Vec3& point_mm) noexcept {
  const std::array<double, 3> weights = skin_weights(mesh, triangle, point_mm);
  const Triangle& corners = mesh.triangles[triangle];
  Vec3 said_mm(0.0);
  for (std::size_t k = 0; k < 3; ++k) said_mm += weights[k] * mesh.points_mm[corners[k]];
  const Vec3 error_mm = said_mm - point_mm;
  const double sum = weights[0] + weights[1] + weights[2];
  if (glm::dot(error_mm, error_mm) < sound_mm * sound_mm && std::abs(sum - 1.0) < side_weight) {
    return weights;
  }
  std::size_t longest = 0;
  double longest_mm2 = -1.0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 side = mesh.points_mm[corners[(k + 1) % 3]] - mesh.points_mm[corners[k]];
    if (glm::dot(side, side) <= longest_mm2) continue;
    longest_mm2 = glm::dot(side, side);
    longest = k;
  }
  const Vec3& from_mm = mesh.points_mm[corners[longest]];
  const Vec3 side = mesh.points_mm[corners[(longest + 1) % 3]] - from_mm;
  std::array<double, 3> shares{};
  const double share = longest_mm2 > 0.0 ? glm::dot(point_mm - from_mm, side) / longest_mm2 : 0.0;
  shares[(longest + 1) % 3] = std::clamp(share, 0.0, 1.0);
  shares[longest] = 1.0 - shares[(longest + 1) % 3];
  return shares;
}

bool is_skin(const FaceOrigin& origin) noexcept { return origin.kerf == -1; }

}  // namespace

WorkingSolid::WorkingSolid(const CutSolid& solid, const SpareRoom& room)
    : WorkingSolid(solid, room, true) {}

WorkingSolid::WorkingSolid(const CutSolid& solid, const SpareRoom& room, bool finds_skin)
    : mesh_(half_edges_of(solid.mesh, "the solid being cut")) {
  mesh_.request_vertex_status();
  mesh_.request_halfedge_status();
  mesh_.request_edge_status();
  mesh_.request_face_status();
  mesh_.add_property(origin_, "origin");
  mesh_.add_property(skin_, "skin");
  vertices_at_most_ = mesh_.n_vertices() + room.points;
  faces_at_most_ = mesh_.n_faces() + room.triangles;
  edges_at_most_ = mesh_.n_edges() + (3 * room.triangles + 1) / 2;
  // After the properties were added: they are given the same room.
  mesh_.reserve(vertices_at_most_, edges_at_most_, faces_at_most_);
  for (std::size_t i = 0; i < solid.origins.size(); ++i) {
    mesh_.property(origin_, face_handle(i)) = solid.origins[i];
  }
  if (finds_skin) find_skin();
}

SpareRoom WorkingSolid::room_left() const noexcept {
  const std::size_t edges_left =
      edges_at_most_ - std::min<std::size_t>(edges_at_most_, mesh_.n_edges());
  return {vertices_at_most_ - std::min<std::size_t>(vertices_at_most_, mesh_.n_vertices()),
          std::min(faces_at_most_ - mesh_.n_faces(), 2 * edges_left / 3)};
}

void WorkingSolid::find_skin() {
  for (const auto face : mesh_.faces()) {
    if (!is_skin(mesh_.property(origin_, face))) continue;
    const std::array<VertexHandle, 3> corners = corners_of(mesh_, face);
    const Vec3 from_mm = place_of(mesh_, corners[0]);
    const Vec3 twice_area =
        glm::cross(place_of(mesh_, corners[1]) - from_mm, place_of(mesh_, corners[2]) - from_mm);
    for (const VertexHandle corner : corners) {
      SkinPoint& skin = mesh_.property(skin_, corner);
      skin.on_bone_mm = place_of(mesh_, corner);
      skin.normal += twice_area;
      skin.is_on_skin = true;
    }
  }
  for (const auto vertex : mesh_.vertices()) {
    SkinPoint& skin = mesh_.property(skin_, vertex);
    skin.normal = unit(skin.normal);
  }
}

IndexedSolid WorkingSolid::indexed() const {
  IndexedSolid base;
  base.commits = commits_;
  std::vector<std::uint32_t> point_of(mesh_.n_vertices(), no_index);
  for (std::uint32_t i = 0; i < mesh_.n_vertices(); ++i) {
    if (mesh_.status(vertex_handle(i)).deleted()) continue;
    point_of[i] = static_cast<std::uint32_t>(base.vertices.size());
    base.vertices.push_back(i);
    base.solid.mesh.points_mm.push_back(place_of(mesh_, vertex_handle(i)));
  }
  for (std::uint32_t i = 0; i < mesh_.n_faces(); ++i) {
    const FaceHandle face = face_handle(i);
    if (mesh_.status(face).deleted()) continue;
    Triangle triangle{};
    std::size_t k = 0;
    for (const VertexHandle corner : corners_of(mesh_, face)) {
      triangle[k++] = point_of[static_cast<std::size_t>(corner.idx())];
    }
    base.faces.push_back(i);
    base.solid.mesh.triangles.push_back(triangle);
    base.solid.origins.push_back(mesh_.property(origin_, face));
  }
  return base;
}

void WorkingSolid::show(const SolidPatch& patch, const IndexedSolid& base) {
  CHECK(base.commits == commits_);
  for (const FaceHandle face : hidden_) mesh_.status(face).set_hidden(false);
  hidden_.clear();
  for (const std::uint32_t triangle : patch.hidden) {
    hidden_.push_back(face_handle(base.faces[triangle]));
    mesh_.status(hidden_.back()).set_hidden(true);
  }
}

SkinPoint WorkingSolid::blend(const std::array<SkinPoint, 3>& corners,
                              const std::array<double, 3>& weights) noexcept {
  SkinPoint sum;
  sum.is_on_skin = true;
  for (std::size_t k = 0; k < 3; ++k) {
    if (!corners[k].is_on_skin) return {};
    sum.on_bone_mm += weights[k] * corners[k].on_bone_mm;
    sum.normal += weights[k] * corners[k].normal;
  }
  sum.normal = unit(sum.normal);
  return sum;
}

/// A parent that is an earlier kerf's wall counts only where the point lies on its side towards skin: between the ends of
/// that side. Other points of a wall have no skin, though all corners of the wall may.
SkinPoint WorkingSolid::skin_at(const IndexedSolid& base, std::uint32_t parent,
                                const Vec3& point_mm) const {
  if (parent == no_index) return {};
  const FaceHandle face = face_handle(base.faces[parent]);
  std::array<double, 3> weights = sound_weights(base.solid.mesh, parent, point_mm);
  std::array<SkinPoint, 3> corners;
  std::transform(base.solid.mesh.triangles[parent].begin(), base.solid.mesh.triangles[parent].end(),
                 corners.begin(), [&](std::uint32_t point) {
                   return mesh_.property(skin_, vertex_handle(base.vertices[point]));
                 });
  if (is_skin(mesh_.property(origin_, face))) return blend(corners, weights);
  auto side = mesh_.next_halfedge_handle(mesh_.halfedge_handle(face));
  for (std::size_t k = 0; k < 3; ++k, side = mesh_.next_halfedge_handle(side)) {
    const std::size_t across = (k + 2) % 3;
    if (std::abs(weights[across]) > side_weight) continue;
    const FaceHandle beside = mesh_.face_handle(mesh_.opposite_halfedge_handle(side));
    if (!is_skin(mesh_.property(origin_, beside))) continue;
    corners[across] = corners[k];
    weights[across] = 0.0;
    return blend(corners, weights);
  }
  return {};
}

WorkingSolid WorkingSolid::compacted(const SpareRoom& room) const {
  const IndexedSolid base = indexed();
  std::vector<std::uint32_t> all(base.faces.size());
  for (std::uint32_t i = 0; i < all.size(); ++i) all[i] = i;
  WorkingSolid copy(base.solid, room, false);
  copy.take_skin(*this, base, all, base.solid);
  return copy;
}

WorkingPieces WorkingSolid::pieces(const SpareRoom& room) const {
  const IndexedSolid base = indexed();
  WorkingPieces pieces;
  for (const SolidPiece& piece : find_pieces(base.solid)) {
    const double volume_mm3 = signed_volume_mm3(piece.solid.mesh);
    if (volume_mm3 < debris_limit_mm3) {
      ++pieces.debris_count;
      pieces.debris_mm3 += volume_mm3;
      continue;
    }
    WorkingSolid body(piece.solid, room, false);
    body.take_skin(*this, base, piece.triangles, piece.solid);
    pieces.bodies.push_back(std::move(body));
  }
  return pieces;
}

/// `triangles` names each face's triangle in `base`, whose faces are those of `from`.
void WorkingSolid::take_skin(const WorkingSolid& from, const IndexedSolid& base,
                             const std::vector<std::uint32_t>& triangles, const CutSolid& part) {
  CHECK(triangles.size() == part.mesh.triangles.size() && triangles.size() == mesh_.n_faces());
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const auto own = corners_of(mesh_, face_handle(i));
    const auto theirs = corners_of(from.mesh_, face_handle(base.faces[triangles[i]]));
    for (std::size_t k = 0; k < 3; ++k) {
      mesh_.property(skin_, own[k]) = from.mesh_.property(from.skin_, theirs[k]);
    }
  }
}

}  // namespace hallux::simulator
