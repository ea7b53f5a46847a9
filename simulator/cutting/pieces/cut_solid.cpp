#include "simulator/cutting/pieces/cut_solid.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "simulator/cutting/pieces/edge_uses.h"

namespace hallux::simulator {

namespace {

struct Piece : SolidPiece {
  double volume_mm3 = 0.0;
  std::uint32_t lowest_point = 0;
  Vec3 min_mm{0.0, 0.0, 0.0}, max_mm{0.0, 0.0, 0.0};
};

Piece piece_of(const CutSolid& solid, const std::vector<std::uint32_t>& triangles,
               std::vector<std::uint32_t>& index_scratch) {
  constexpr std::uint32_t absent = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> points;
  for (const std::uint32_t triangle : triangles) {
    for (const std::uint32_t corner : solid.mesh.triangles[triangle]) points.push_back(corner);
  }
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  Piece piece;
  piece.triangles = triangles;
  piece.lowest_point = points.front();
  piece.min_mm = piece.max_mm = solid.mesh.points_mm[points.front()];
  for (const std::uint32_t point : points) {
    const Vec3& point_mm = solid.mesh.points_mm[point];
    index_scratch[point] = static_cast<std::uint32_t>(piece.solid.mesh.points_mm.size());
    piece.solid.mesh.points_mm.push_back(point_mm);
    piece.min_mm = glm::min(piece.min_mm, point_mm);
    piece.max_mm = glm::max(piece.max_mm, point_mm);
  }
  for (const std::uint32_t triangle : triangles) {
    const Triangle& corners = solid.mesh.triangles[triangle];
    piece.solid.mesh.triangles.push_back(
        {index_scratch[corners[0]], index_scratch[corners[1]], index_scratch[corners[2]]});
    piece.solid.sources.push_back(solid.sources[triangle]);
  }
  for (const std::uint32_t point : points) index_scratch[point] = absent;
  piece.volume_mm3 = signed_volume_mm3(piece.solid.mesh);
  return piece;
}

/// Whether the triangle's edge from a to b, seen along x, passes above the point's y at the point's
/// z. Computed from the lower end, so that both triangles of an edge get the same answer.
bool passes_above(const Vec3& a, const Vec3& b, const Vec3& point_mm) noexcept {
  if ((a.z > point_mm.z) == (b.z > point_mm.z)) return false;
  const Vec3& low = a.z < b.z ? a : b;
  const Vec3& high = a.z < b.z ? b : a;
  return low.y + (point_mm.z - low.z) / (high.z - low.z) * (high.y - low.y) > point_mm.y;
}

/// By the parity of crossings of a ray along x.
bool encloses(const IndexedMesh& mesh, const Vec3& point_mm) noexcept {
  bool is_inside = false;
  for (std::size_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
    const auto [a, b, c] = corners_of(mesh, triangle);
    const bool is_over_triangle = (passes_above(a, b, point_mm) != passes_above(b, c, point_mm)) !=
                                  passes_above(c, a, point_mm);
    if (!is_over_triangle) continue;
    const Vec3 normal = glm::cross(b - a, c - a);
    const double height = glm::dot(normal, a - point_mm);
    if (normal.x != 0.0 && (height > 0.0) == (normal.x > 0.0)) is_inside = !is_inside;
  }
  return is_inside;
}

bool may_hold(const Piece& outer, const Piece& inner) noexcept {
  return glm::all(glm::lessThanEqual(outer.min_mm, inner.min_mm)) &&
         glm::all(glm::greaterThanEqual(outer.max_mm, inner.max_mm));
}

/// The smallest outward shell around an inward-facing one.
Piece* shell_around(std::vector<Piece>& outward, const Piece& inward) {
  Piece* best = nullptr;
  for (Piece& piece : outward) {
    if (best != nullptr && piece.volume_mm3 >= best->volume_mm3) continue;
    if (!may_hold(piece, inward)) continue;
    if (encloses(piece.solid.mesh, inward.solid.mesh.points_mm.front())) best = &piece;
  }
  return best;
}

void add_shell(Piece& piece, const Piece& shell) {
  append_solid(piece.solid, shell.solid);
  piece.triangles.insert(piece.triangles.end(), shell.triangles.begin(), shell.triangles.end());
}

}  // namespace

CutSolid uncut_solid(IndexedMesh mesh) {
  CutSolid solid;
  solid.sources.resize(mesh.triangles.size());
  solid.mesh = std::move(mesh);
  return solid;
}

void append_solid(CutSolid& solid, const CutSolid& added) {
  append_mesh(solid.mesh, added.mesh);
  solid.sources.insert(solid.sources.end(), added.sources.begin(), added.sources.end());
}

std::vector<SolidPiece> find_pieces(const CutSolid& solid) {
  std::vector<Piece> outward, inward;
  std::vector<std::uint32_t> index_scratch(solid.mesh.points_mm.size());
  for (const std::vector<std::uint32_t>& shell : sets_by_edges(solid.mesh.triangles).groups()) {
    Piece piece = piece_of(solid, shell, index_scratch);
    (piece.volume_mm3 < 0.0 ? inward : outward).push_back(std::move(piece));
  }
  // Homes are found among bare outward shells, before any of them takes in its canals.
  std::vector<std::pair<Piece*, const Piece*>> homes;
  std::vector<Piece> homeless;
  for (const Piece& shell : inward) {
    Piece* home = shell_around(outward, shell);
    if (home != nullptr) {
      homes.emplace_back(home, &shell);
    } else {
      homeless.push_back(shell);
    }
  }
  for (const auto& [home, shell] : homes) add_shell(*home, *shell);
  for (const auto& [home, shell] : homes) home->volume_mm3 += shell->volume_mm3;
  outward.insert(outward.end(), homeless.begin(), homeless.end());
  std::sort(outward.begin(), outward.end(), [](const Piece& a, const Piece& b) {
    return std::pair(-a.volume_mm3, a.lowest_point) < std::pair(-b.volume_mm3, b.lowest_point);
  });
  std::vector<SolidPiece> pieces;
  pieces.reserve(outward.size());
  for (Piece& piece : outward) pieces.push_back(std::move(static_cast<SolidPiece&>(piece)));
  return pieces;
}

std::vector<CutSolid> split_pieces(const CutSolid& solid) {
  std::vector<CutSolid> solids;
  for (SolidPiece& piece : find_pieces(solid)) solids.push_back(std::move(piece.solid));
  return solids;
}

}  // namespace hallux::simulator
