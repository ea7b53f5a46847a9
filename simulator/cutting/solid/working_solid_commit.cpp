#include <algorithm>
#include <tuple>

#include "simulator/base/check.h"
#include "simulator/cutting/solid/working_solid.h"

/// A commit joins new faces to standing ones by the pairs of points that they name, sorted: OpenMesh's delete_face and
/// add_face would find the same neighbours face by face, take memory for each, and could stop half-way at a point that
/// two fans share.
namespace hallux::simulator {

using OpenMesh::FaceHandle;
using OpenMesh::HalfedgeHandle;
using OpenMesh::VertexHandle;

namespace {

FaceHandle face_handle(std::size_t index) { return FaceHandle(static_cast<int>(index)); }
VertexHandle vertex_handle(std::size_t index) { return VertexHandle(static_cast<int>(index)); }

}  // namespace

CommitOutcome WorkingSolid::commit(const SolidPatch& patch, const IndexedSolid& base) {
  CHECK(base.commits == commits_);
  take_in(patch, base);
  if (!has_room()) return CommitOutcome::NoRoom;
  show({}, base);
  delete_hidden(patch, base);
  add_vertices();
  add_sides();
  add_faces();
  separate_fans();
  delete_unused_vertices();
  ++commits_;
  return CommitOutcome::Done;
}

/// The patch in terms of vertices, without the points that it does not use, each pair of points named by two sides.
void WorkingSolid::take_in(const SolidPatch& patch, const IndexedSolid& base) {
  const std::size_t base_points = base.vertices.size();
  first_vertex_ = static_cast<std::uint32_t>(mesh_.n_vertices());
  first_face_ = static_cast<std::uint32_t>(mesh_.n_faces());
  new_vertex_of_.assign(patch.points_in_bone_mm.size(), no_index);
  new_points_mm_.clear();
  new_skins_.clear();
  new_triangles_.clear();
  for (const Triangle& triangle : patch.triangles) {
    for (const std::uint32_t corner : triangle) {
      if (corner >= base_points) new_vertex_of_[corner - base_points] = 0;
    }
  }
  for (std::size_t i = 0; i < patch.points_in_bone_mm.size(); ++i) {
    if (new_vertex_of_[i] == no_index) continue;
    new_vertex_of_[i] = first_vertex_ + static_cast<std::uint32_t>(new_points_mm_.size());
    new_points_mm_.push_back(patch.points_in_bone_mm[i]);
    new_skins_.push_back(skin_at(base, patch.parents[i], patch.points_in_bone_mm[i]));
  }
  for (const Triangle& triangle : patch.triangles) {
    Triangle& added = new_triangles_.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t corner = triangle[k];
      added[k] =
          corner < base_points ? base.vertices[corner] : new_vertex_of_[corner - base_points];
    }
  }
  new_origins_.assign(patch.origins.begin(), patch.origins.end());
  separate_repeated();
}

/// A middle of two points on the skin lies on it only where a face of the skin has it: walls run between such points too.
void WorkingSolid::separate_repeated() {
  const std::size_t first_middle = new_points_mm_.size();
  mender_.separate(new_triangles_, new_origins_, 0,
                   [this](std::uint32_t a, std::uint32_t b) { return add_middle(a, b); });
  const auto is_of_skin = [&](std::size_t point) {
    for (std::size_t i = 0; i < new_triangles_.size(); ++i) {
      const Triangle& corners = new_triangles_[i];
      const bool has_point =
          std::find(corners.begin(), corners.end(), first_vertex_ + point) != corners.end();
      if (has_point && new_origins_[i].kerf == -1) return true;
    }
    return false;
  };
  for (std::size_t point = first_middle; point < new_points_mm_.size(); ++point) {
    if (!is_of_skin(point)) new_skins_[point] = {};
  }
}

std::uint32_t WorkingSolid::add_middle(std::uint32_t a, std::uint32_t b) {
  const auto place_mm = [this](std::uint32_t vertex) {
    if (vertex >= first_vertex_) return new_points_mm_[vertex - first_vertex_];
    const OpenMesh::Vec3d& point = mesh_.point(vertex_handle(vertex));
    return Vec3(point[0], point[1], point[2]);
  };
  const auto skin_of = [this](std::uint32_t vertex) {
    return vertex >= first_vertex_ ? new_skins_[vertex - first_vertex_]
                                   : mesh_.property(skin_, vertex_handle(vertex));
  };
  const Vec3 middle_mm = 0.5 * (place_mm(a) + place_mm(b));
  const SkinPoint middle = blend({skin_of(a), skin_of(b), skin_of(b)}, {0.5, 0.5, 0.0});
  new_points_mm_.push_back(middle_mm);
  new_skins_.push_back(middle);
  return first_vertex_ + static_cast<std::uint32_t>(new_points_mm_.size() - 1);
}

bool WorkingSolid::has_room() const noexcept {
  const SpareRoom left = room_left();
  return new_points_mm_.size() <= left.points && new_triangles_.size() <= left.triangles;
}

void WorkingSolid::delete_hidden(const SolidPatch& patch, const IndexedSolid& base) {
  rim_.clear();
  touched_.clear();
  for (const std::uint32_t triangle : patch.hidden) {
    mesh_.status(face_handle(base.faces[triangle])).set_deleted(true);
  }
  for (const std::uint32_t triangle : patch.hidden) {
    HalfedgeHandle side = mesh_.halfedge_handle(face_handle(base.faces[triangle]));
    for (int k = 0; k < 3; ++k, side = mesh_.next_halfedge_handle(side)) {
      const auto from = static_cast<std::uint32_t>(mesh_.from_vertex_handle(side).idx());
      const auto to = static_cast<std::uint32_t>(mesh_.to_vertex_handle(side).idx());
      touched_.push_back(vertex_handle(from));
      const HalfedgeHandle opposite = mesh_.opposite_halfedge_handle(side);
      if (!mesh_.status(mesh_.face_handle(opposite)).deleted()) {
        const std::uint64_t edge = (std::uint64_t{std::min(from, to)} << 32U) | std::max(from, to);
        rim_.push_back({edge, from > to, side});
        continue;
      }
      mesh_.status(side).set_deleted(true);
      mesh_.status(opposite).set_deleted(true);
      mesh_.status(mesh_.edge_handle(side)).set_deleted(true);
    }
  }
  for (const VertexHandle vertex : touched_) mesh_.set_isolated(vertex);
  std::sort(rim_.begin(), rim_.end(), [](const RimSide& a, const RimSide& b) {
    return std::tie(a.edge, a.is_descending) < std::tie(b.edge, b.is_descending);
  });
}

void WorkingSolid::add_vertices() {
  for (std::size_t i = 0; i < new_points_mm_.size(); ++i) {
    const Vec3& point_mm = new_points_mm_[i];
    const VertexHandle vertex = mesh_.add_vertex({point_mm.x, point_mm.y, point_mm.z});
    mesh_.property(skin_, vertex) = new_skins_[i];
  }
}

/// Each pair of points is named by two new triangles, which get a new edge, or by one, which gets the side of the rim that a
/// hidden face had.
void WorkingSolid::add_sides() {
  sides_.assign(3 * new_triangles_.size(), HalfedgeHandle());
  const std::vector<EdgeUse>& uses = mender_.uses();
  const auto give = [&](const EdgeUse& use, HalfedgeHandle side) {
    const auto low = static_cast<std::uint32_t>(use.edge >> 32U);
    const auto high = static_cast<std::uint32_t>(use.edge & 0xffffffffU);
    const Triangle& corners = new_triangles_[use.triangle];
    std::size_t k = 0;
    while (corners[k] != (use.is_descending ? high : low) ||
           corners[(k + 1) % 3] != (use.is_descending ? low : high)) {
      ++k;
    }
    sides_[3 * use.triangle + k] = side;
  };
  for (std::size_t i = 0; i < uses.size();) {
    const EdgeUse& use = uses[i];
    const bool is_pair = i + 1 < uses.size() && uses[i + 1].edge == use.edge;
    if (is_pair) {
      const HalfedgeHandle ascending =
          mesh_.new_edge(vertex_handle(use.edge >> 32U), vertex_handle(use.edge & 0xffffffffU));
      const HalfedgeHandle descending = mesh_.opposite_halfedge_handle(ascending);
      CHECK(use.is_descending != uses[i + 1].is_descending);
      give(use, use.is_descending ? descending : ascending);
      give(uses[i + 1], use.is_descending ? ascending : descending);
      i += 2;
      continue;
    }
    const auto rim = std::lower_bound(rim_.begin(), rim_.end(), use,
                                      [](const RimSide& side, const EdgeUse& wanted) {
                                        return std::tie(side.edge, side.is_descending) <
                                               std::tie(wanted.edge, wanted.is_descending);
                                      });
    CHECK(rim != rim_.end() && rim->edge == use.edge && rim->is_descending == use.is_descending);
    give(use, rim->side);
    ++i;
  }
}

void WorkingSolid::add_faces() {
  for (std::size_t i = 0; i < new_triangles_.size(); ++i) {
    const FaceHandle face = mesh_.new_face();
    mesh_.property(origin_, face) = new_origins_[i];
    mesh_.set_halfedge_handle(face, sides_[3 * i + 2]);
    for (std::size_t k = 0; k < 3; ++k) {
      const HalfedgeHandle side = sides_[3 * i + k];
      mesh_.set_face_handle(side, face);
      mesh_.set_next_halfedge_handle(side, sides_[3 * i + (k + 1) % 3]);
      mesh_.set_halfedge_handle(vertex_handle(new_triangles_[i][k]), side);
    }
  }
}

/// Half-edges cannot walk from one fan of faces to another around the same point: all fans but that of the point's own
/// half-edge get a copy of it. Each fan at a touched point has a new face, so walks from new faces find them all.
void WorkingSolid::separate_fans() {
  is_walked_.assign(sides_.size(), 0);
  const auto next_around = [this](HalfedgeHandle leaving) {
    return mesh_.opposite_halfedge_handle(mesh_.prev_halfedge_handle(leaving));
  };
  const auto mark = [this](HalfedgeHandle leaving) {
    const auto face = static_cast<std::size_t>(mesh_.face_handle(leaving).idx());
    if (face < first_face_) return;
    const std::size_t first = 3 * (face - first_face_);
    for (std::size_t k = 0; k < 3; ++k) {
      if (sides_[first + k] == leaving) is_walked_[first + k] = 1;
    }
  };
  for (std::size_t i = 0; i < sides_.size(); ++i) {
    if (is_walked_[i] != 0) continue;
    const VertexHandle vertex = mesh_.from_vertex_handle(sides_[i]);
    bool has_own = false;
    HalfedgeHandle leaving = sides_[i];
    do {
      mark(leaving);
      has_own = has_own || leaving == mesh_.halfedge_handle(vertex);
      leaving = next_around(leaving);
    } while (leaving != sides_[i]);
    if (has_own) continue;
    const VertexHandle copy = mesh_.add_vertex(OpenMesh::Vec3d(mesh_.point(vertex)));
    mesh_.property(skin_, copy) = SkinPoint{mesh_.property(skin_, vertex)};
    mesh_.set_halfedge_handle(copy, sides_[i]);
    do {
      mesh_.set_vertex_handle(mesh_.opposite_halfedge_handle(leaving), copy);
      leaving = next_around(leaving);
    } while (leaving != sides_[i]);
  }
}

void WorkingSolid::delete_unused_vertices() {
  for (const VertexHandle vertex : touched_) {
    if (!mesh_.halfedge_handle(vertex).is_valid()) mesh_.status(vertex).set_deleted(true);
  }
}

}  // namespace hallux::simulator
