#include "simulator/bone/numbered_pieces.h"

#include <algorithm>
#include <utility>

namespace hallux::simulator {

namespace {

/// Both triangles beside a cut share its plane, so a point is asked this far inside the skin.
constexpr double inward_mm = 1.0e-3;
constexpr std::size_t points_asked = 64;

const Bvh& tree_of(PieceBody& piece) {
  if (!piece.bvh) piece.bvh = std::make_unique<const Bvh>(piece.solid.mesh);
  return *piece.bvh;
}

/// Half way through the solid behind a triangle's middle; nothing where rounding finds no far side.
std::optional<Vec3> half_way_behind(const std::array<Vec3, 3>& corners_mm, const Bvh& bvh) {
  const Vec3 outward = glm::cross(corners_mm[1] - corners_mm[0], corners_mm[2] - corners_mm[0]);
  const double length = length_of(outward);
  if (length == 0.0) return std::nullopt;
  const Vec3 inward = -1.0 / length * outward;
  const Vec3 from_mm = middle_of(corners_mm) + inward_mm * inward;
  const std::optional<RayHit> far_side = bvh.first_hit(from_mm, inward);
  if (!far_side) return std::nullopt;
  const Vec3 point_mm = from_mm + 0.5 * far_side->distance_mm * inward;
  return bvh.contains(point_mm) ? std::optional(point_mm) : std::nullopt;
}

double doubled_area_mm2(const std::array<Vec3, 3>& corners_mm) {
  return length_of(glm::cross(corners_mm[1] - corners_mm[0], corners_mm[2] - corners_mm[0]));
}

}  // namespace

Vec3 point_inside(const CutSolid& solid, const Bvh& bvh) {
  std::vector<std::pair<double, std::uint32_t>> by_area;
  for (std::uint32_t i = 0; i < solid.mesh.triangles.size(); ++i)
    by_area.emplace_back(-doubled_area_mm2(corners_of(solid.mesh, i)), i);
  std::sort(by_area.begin(), by_area.end());
  for (const auto& [area, triangle] : by_area) {
    if (const auto point_mm = half_way_behind(corners_of(solid.mesh, triangle), bvh))
      return *point_mm;
  }
  return middle_of(corners_of(solid.mesh, by_area.front().second));
}

bool lies_in(const CutSolid& piece, const Bvh& body) {
  const std::size_t count = piece.mesh.triangles.size();
  const std::size_t step = std::max<std::size_t>(1, count / points_asked);
  std::size_t asked = 0, inside = 0;
  for (std::size_t i = 0; i < count; i += step) {
    const std::array<Vec3, 3> corners_mm = corners_of(piece.mesh, i);
    const Vec3 outward = glm::cross(corners_mm[1] - corners_mm[0], corners_mm[2] - corners_mm[0]);
    const double length = length_of(outward);
    if (length == 0.0) continue;
    ++asked;
    const Vec3 point_mm = middle_of(corners_mm) - inward_mm / length * outward;
    if (body.contains(point_mm)) ++inside;
  }
  return 2 * inside > asked;
}

SortedBodies sort_bodies(std::vector<CutSolid> solids) {
  SortedBodies sorted;
  for (CutSolid& solid : solids) {
    const double volume_mm3 = signed_volume_mm3(solid.mesh);
    if (volume_mm3 < debris_limit_mm3) {
      sorted.debris_mm3 += volume_mm3;
      sorted.crumbs.push_back(std::move(solid));
    } else {
      sorted.volumes_mm3.push_back(volume_mm3);
      sorted.bodies.push_back(std::move(solid));
    }
  }
  return sorted;
}

NumberedPieces::NumberedPieces(const CutSolid& whole, std::int32_t main) : main_(main) {
  pieces_.push_back({main, false, signed_volume_mm3(whole.mesh), {}, whole, nullptr});
}

std::size_t NumberedPieces::body_of(const CutSolid& solid) const {
  const auto body = std::find_if(taken_out_.begin(), taken_out_.end(),
                                 [&](const auto& taken) { return lies_in(solid, *taken); });
  return static_cast<std::size_t>(body - taken_out_.begin());
}

/// The number of the piece that this one was cut from, if no larger part of that has taken it; else
/// -1.
std::int32_t NumberedPieces::inherited_id(const CutSolid& solid, std::vector<std::int32_t>& taken) {
  for (PieceBody& piece : pieces_) {
    if (std::find(taken.begin(), taken.end(), piece.id) != taken.end()) continue;
    if (!lies_in(solid, tree_of(piece))) continue;
    taken.push_back(piece.id);
    return piece.id;
  }
  return -1;
}

void NumberedPieces::number(std::vector<CutSolid> solids, std::int32_t& next_id) {
  std::erase_if(solids, [&](const CutSolid& solid) { return body_of(solid) < taken_out_.size(); });
  SortedBodies sorted = sort_bodies(std::move(solids));
  std::vector<PieceBody> numbered;
  std::vector<std::int32_t> taken;
  for (std::size_t i = 0; i < sorted.bodies.size(); ++i) {
    CutSolid& solid = sorted.bodies[i];
    const std::int32_t inherited = inherited_id(solid, taken);
    const bool is_new = inherited < 0;
    const std::int32_t id = is_new ? next_id++ : inherited;
    numbered.push_back({id, is_new, sorted.volumes_mm3[i], {}, std::move(solid), nullptr});
  }
  keep(std::move(numbered), std::move(sorted));
}

NumberedPieces NumberedPieces::of_part(const CutSolid& part, std::int32_t main) const {
  NumberedPieces own(CutSolid{}, main);
  SortedBodies sorted = sort_bodies(split_pieces(part));
  std::vector<PieceBody> numbered;
  for (std::size_t i = 0; i < sorted.bodies.size(); ++i) {
    CutSolid& solid = sorted.bodies[i];
    const auto in = std::find_if(pieces_.begin(), pieces_.end(), [&](const PieceBody& piece) {
      return piece.id != main_ && lies_in(solid, Bvh(piece.solid.mesh));
    });
    const std::int32_t id = in == pieces_.end() ? main : in->id;
    numbered.push_back({id, false, sorted.volumes_mm3[i], {}, std::move(solid), nullptr});
  }
  own.keep(std::move(numbered), std::move(sorted));
  return own;
}

void NumberedPieces::keep(std::vector<PieceBody> numbered, SortedBodies sorted) {
  for (PieceBody& piece : numbered) {
    if (piece.id != main_) piece.inside_mm = point_inside(piece.solid, tree_of(piece));
  }
  pieces_ = std::move(numbered);
  crumbs_ = std::move(sorted.crumbs);
  debris_mm3_ = sorted.debris_mm3;
}

const Bvh* NumberedPieces::take_out(std::int32_t id) {
  const auto found = std::find_if(pieces_.begin(), pieces_.end(),
                                  [id](const PieceBody& piece) { return piece.id == id; });
  if (found == pieces_.end()) return nullptr;
  tree_of(*found);
  taken_out_.push_back(std::move(found->bvh));
  pieces_.erase(found);
  return taken_out_.back().get();
}

std::vector<const Bvh*> NumberedPieces::taken_out() const {
  std::vector<const Bvh*> bodies;
  bodies.reserve(taken_out_.size());
  for (const auto& body : taken_out_) bodies.push_back(body.get());
  return bodies;
}

CutSolid NumberedPieces::gathered_without(std::int32_t id) const {
  CutSolid all;
  for (const PieceBody& piece : pieces_) {
    if (piece.id != id) append_solid(all, piece.solid);
  }
  for (const CutSolid& crumb : crumbs_) append_solid(all, crumb);
  return all;
}

std::optional<CutSolid> NumberedPieces::without_taken_out(const CutSolid& solid) const {
  if (taken_out_.empty()) return solid;
  std::vector<bool> is_found(taken_out_.size(), false);
  CutSolid left;
  for (const CutSolid& piece : split_pieces(solid)) {
    const std::size_t body = body_of(piece);
    if (body < taken_out_.size()) {
      is_found[body] = true;
    } else {
      append_solid(left, piece);
    }
  }
  if (std::find(is_found.begin(), is_found.end(), false) != is_found.end()) return std::nullopt;
  return left;
}

}  // namespace hallux::simulator
