/// Every face is gathered as directed edges and filled from them: skin around the region, two walls
/// on the planes, a front over each edge of the outline. An edge is cut into pieces once, by
/// pairing the signed marks along it in order, and used by its two faces in opposite directions; so
/// the patch is closed whatever rounding does, and no tolerance decides about it. Windings that do
/// not pair refuse the frame, and the patch before it stays.
#include "simulator/cutting/solid/solid_patch.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hallux::simulator {

namespace {

std::int64_t between(std::int64_t a, std::int64_t b, double share) noexcept {
  return a + static_cast<std::int64_t>(std::floor(share * static_cast<double>(b - a) + 0.5));
}

LatticeCorner between(const LatticeCorner& a, const LatticeCorner& b, double share) noexcept {
  return {{between(a.place.u, b.place.u, share), between(a.place.v, b.place.v, share)},
          between(a.height, b.height, share)};
}

Vec3 point_at(const KerfAxes& axes, const Vec2& place_in_kerf_mm, double height_in_kerf_mm) {
  return axes.origin_mm + place_in_kerf_mm.x * axes.x + place_in_kerf_mm.y * axes.y +
         height_in_kerf_mm * axes.z;
}

}  // namespace

PatchBuilder::PatchBuilder(const SlabSlice& contact)
    : contact_(contact), arrangement_(contact), newest_hit_on_(contact.triangles.size(), no_index) {
  for (const StripPoint& point : contact.points) {
    corners_.push_back({point.place, point.height});
    named_.push_back(point.base_point);
    if (point.base_point != no_index) continue;
    named_.back() =
        contact.base_point_count + static_cast<std::uint32_t>(made_.points_in_bone_mm.size());
    made_.points_in_bone_mm.push_back(point.point_in_bone_mm);
    made_.parents.push_back(contact.touched[point.touched].base_triangle);
  }
  static_points_ = made_.points_in_bone_mm.size();
}

bool PatchBuilder::build(const RegionOutline& region, SolidPatch& patch) {
  bool is_sound = arrangement_.arrange(region);
  if (is_sound) {
    begin();
    add_points();
    is_sound = find_section_pieces() && find_uprights() && add_skin();
    for (std::uint32_t edge = 0; is_sound && edge < arrangement_.corners().size(); ++edge) {
      is_sound = add_front(edge);
    }
    is_sound = is_sound && add_wall(1) && add_wall(-1);
  }
  if (!is_sound) {
    ++refusals_;
    return false;
  }
  // What was made stays for the next frame: only its points that never move are needed there.
  patch.points_in_bone_mm.assign(made_.points_in_bone_mm.begin(), made_.points_in_bone_mm.end());
  patch.parents.assign(made_.parents.begin(), made_.parents.end());
  std::swap(patch.hidden, made_.hidden);
  std::swap(patch.triangles, made_.triangles);
  std::swap(patch.sources, made_.sources);
  return true;
}

void PatchBuilder::begin() {
  corners_.resize(contact_.points.size());
  named_.resize(contact_.points.size());
  made_.points_in_bone_mm.resize(static_points_);
  made_.parents.resize(static_points_);
  made_.hidden.clear();
  made_.triangles.clear();
  made_.sources.clear();
  cuts_.clear();
  newest_cut_of_.assign(arrangement_.corners().size(), no_index);
}

std::uint32_t PatchBuilder::add_point(const LatticeCorner& corner, const Vec3& point_in_bone_mm,
                                      std::uint32_t parent) {
  corners_.push_back(corner);
  named_.push_back(contact_.base_point_count +
                   static_cast<std::uint32_t>(made_.points_in_bone_mm.size()));
  made_.points_in_bone_mm.push_back(point_in_bone_mm);
  made_.parents.push_back(parent);
  return static_cast<std::uint32_t>(corners_.size() - 1);
}

void PatchBuilder::add_points() {
  add_crossing_points();
  add_hit_points();
  add_corner_points();
}

void PatchBuilder::add_crossing_points() {
  first_crossing_point_ = static_cast<std::uint32_t>(corners_.size());
  for (const StripCrossing& crossing : arrangement_.crossings()) {
    const StripEdge& edge = contact_.edges[crossing.strip_edge];
    const Vec3& a_mm = contact_.points[edge.a].point_in_bone_mm;
    const Vec3& b_mm = contact_.points[edge.b].point_in_bone_mm;
    add_point(between(corners_[edge.a], corners_[edge.b], crossing.strip_share),
              a_mm + crossing.strip_share * (b_mm - a_mm),
              contact_.touched[edge.touched].base_triangle);
  }
}

void PatchBuilder::add_hit_points() {
  first_hit_point_ = static_cast<std::uint32_t>(corners_.size());
  for (const std::uint32_t triangle : hit_triangles_) newest_hit_on_[triangle] = no_index;
  hit_triangles_.clear();
  next_hit_on_.clear();
  for (const CornerHit& hit : arrangement_.hits()) {
    const StripTriangle& triangle = contact_.triangles[hit.triangle];
    double steps = 0.0, height_in_kerf_mm = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
      const StripPoint& point = contact_.points[triangle.points[k]];
      steps += hit.weights[k] * static_cast<double>(point.height);
      height_in_kerf_mm += hit.weights[k] * height_mm(contact_.axes, point.point_in_bone_mm);
    }
    const RegionCorner& corner = arrangement_.corners()[hit.corner];
    add_point({corner.place, static_cast<std::int64_t>(std::floor(steps + 0.5))},
              point_at(contact_.axes, corner.place_mm, height_in_kerf_mm),
              contact_.touched[triangle.touched].base_triangle);
    const auto index = static_cast<std::uint32_t>(next_hit_on_.size());
    next_hit_on_.push_back(std::exchange(newest_hit_on_[hit.triangle], index));
    hit_triangles_.push_back(hit.triangle);
  }
}

void PatchBuilder::add_corner_points() {
  const double half_mm = 0.5 * contact_.plane.thickness_mm;
  const std::int64_t half = contact_.lattice.snap_height(half_mm);
  upper_corner_.clear();
  lower_corner_.clear();
  for (const RegionCorner& corner : arrangement_.corners()) {
    const auto add = [&](std::int32_t windings, std::int32_t side) {
      if (windings == 0) return no_index;
      return add_point({corner.place, side * half},
                       point_at(contact_.axes, corner.place_mm, side * half_mm), no_index);
    };
    upper_corner_.push_back(add(corner.windings_above, 1));
    lower_corner_.push_back(add(corner.windings_below, -1));
  }
}

void PatchBuilder::push_triangle(const Triangle& triangle, const FaceSource& source) {
  made_.triangles.push_back({named_[triangle[0]], named_[triangle[1]], named_[triangle[2]]});
  made_.sources.push_back(source);
}

bool PatchBuilder::add_skin() {
  for (std::size_t i = 0; i < contact_.touched.size(); ++i) {
    const TouchedTriangle& touched = contact_.touched[i];
    if (!arrangement_.is_reached(touched.skin)) continue;
    made_.hidden.push_back(touched.base_triangle);
    const bool is_last = i + 1 == contact_.touched.size();
    const std::size_t strip_end =
        is_last ? contact_.triangles.size() : contact_.touched[i + 1].first_strip;
    const std::size_t outer_end =
        is_last ? contact_.outer_parts.size() : contact_.touched[i + 1].first_outer;
    for (std::uint32_t k = touched.first_strip; k < strip_end; ++k) {
      if (!add_strip_triangle(k)) return false;
    }
    for (std::uint32_t k = touched.first_outer; k < outer_end; ++k) {
      add_outer_part(contact_.outer_parts[k]);
    }
  }
  return true;
}

/// A fan around the first corner, through every point of the contour edge from its end back to its
/// beginning.
void PatchBuilder::add_outer_part(const OuterPart& part) {
  const StripEdge& edge = contact_.edges[part.edge];
  const FaceSource& source = contact_.sources[part.touched];
  std::uint32_t last = named_[edge.b];
  const auto add = [&](std::uint32_t next) {
    made_.triangles.push_back({part.corners[0], last, next});
    made_.sources.push_back(source);
    last = next;
  };
  if (part.corner_count == 2) {
    last = part.corners[1];
    add(named_[edge.b]);
  }
  const std::span<const std::uint32_t> chain = arrangement_.chain(part.edge);
  for (std::size_t i = chain.size(); i-- > 0;) add(named_[first_crossing_point_ + chain[i]]);
  add(named_[edge.a]);
}

bool PatchBuilder::add_strip_triangle(std::uint32_t triangle) {
  const StripTriangle& strip = contact_.triangles[triangle];
  bool is_cut = newest_hit_on_[triangle] != no_index;
  for (const std::uint32_t edge : strip.edges) is_cut = is_cut || !arrangement_.chain(edge).empty();
  if (is_cut) return add_cut_triangle(triangle);
  if (!arrangement_.is_open(strip.points[0])) {
    push_triangle(strip.points, contact_.sources[strip.touched]);
  }
  return true;
}

bool PatchBuilder::add_cut_triangle(std::uint32_t triangle) {
  const StripTriangle& strip = contact_.triangles[triangle];
  filler_.begin();
  for (std::size_t k = 0; k < 3; ++k) {
    for_pieces(strip.edges[k], false, [&](std::uint32_t from, std::uint32_t to) {
      if (strip.runs_along[k]) {
        filler_.add(from, to);
      } else {
        filler_.add(to, from);
      }
    });
  }
  gather_cut_ends(triangle);
  return join_cut_ends() && fill(view_of(triangle), contact_.sources[strip.touched]);
}

/// The walk around the triangle stays outside the region: where a side goes in, the walk goes on
/// along the region's edge against its direction, and comes out where a side leaves the region or
/// the region's edge ends.
void PatchBuilder::gather_cut_ends(std::uint32_t triangle) {
  const StripTriangle& strip = contact_.triangles[triangle];
  cut_ends_.clear();
  for (std::size_t k = 0; k < 3; ++k) {
    for (const std::uint32_t index : arrangement_.chain(strip.edges[k])) {
      const StripCrossing& crossing = arrangement_.crossings()[index];
      const bool goes_in = (crossing.entry > 0) == strip.runs_along[k];
      cut_ends_.push_back({crossing.region_edge, first_crossing_point_ + index, goes_in});
    }
  }
  for (std::uint32_t hit = newest_hit_on_[triangle]; hit != no_index; hit = next_hit_on_[hit]) {
    const std::uint32_t corner = arrangement_.hits()[hit].corner;
    const std::uint32_t point = first_hit_point_ + hit;
    const bool faces_up = strip.facing > 0;
    cut_ends_.push_back({arrangement_.corners()[corner].before, point, faces_up});
    cut_ends_.push_back({corner, point, !faces_up});
  }
}

bool PatchBuilder::join_cut_ends() {
  std::sort(cut_ends_.begin(), cut_ends_.end(), [](const CutEnd& a, const CutEnd& b) {
    return std::pair(a.region_edge, !a.is_start) < std::pair(b.region_edge, !b.is_start);
  });
  if (cut_ends_.size() % 2 != 0) return false;
  for (std::size_t i = 0; i < cut_ends_.size(); i += 2) {
    const CutEnd& start = cut_ends_[i];
    const CutEnd& end = cut_ends_[i + 1];
    if (start.region_edge != end.region_edge || !start.is_start || end.is_start) return false;
    filler_.add(start.point, end.point);
    const auto index = static_cast<std::uint32_t>(cuts_.size());
    cuts_.push_back(
        {{start.point, end.point}, std::exchange(newest_cut_of_[start.region_edge], index)});
  }
  return true;
}

FaceView PatchBuilder::view_of(std::uint32_t triangle) const noexcept {
  std::array<Vec3, 3> at;
  for (std::size_t k = 0; k < 3; ++k) {
    const LatticeCorner& corner = corners_[contact_.triangles[triangle].points[k]];
    at[k] = Vec3(static_cast<double>(corner.place.u), static_cast<double>(corner.place.v),
                 static_cast<double>(corner.height));
  }
  return view_along(glm::cross(at[1] - at[0], at[2] - at[0]));
}

// The faces that a region leaves inside the bone: fronts along its outline, walls on the kerf's two
// planes.

void PatchBuilder::mark(double at, std::uint32_t point, std::int32_t count) {
  for (std::int32_t i = 0; i < count; ++i) starts_.push_back({at, point});
  for (std::int32_t i = 0; i > count; --i) ends_.push_back({at, point});
}

/// The first start with the first end, and so on.
bool PatchBuilder::pair_marks(std::vector<Piece>& pieces) {
  const auto is_earlier = [](const Mark& a, const Mark& b) {
    return std::pair(a.at, a.point) < std::pair(b.at, b.point);
  };
  std::sort(starts_.begin(), starts_.end(), is_earlier);
  std::sort(ends_.begin(), ends_.end(), is_earlier);
  const bool is_sound = starts_.size() == ends_.size();
  for (std::size_t i = 0; is_sound && i < starts_.size(); ++i) {
    pieces.push_back({starts_[i].point, ends_[i].point});
  }
  starts_.clear();
  ends_.clear();
  return is_sound;
}

/// The parts of each region edge that lie in the bone's section, on either plane.
bool PatchBuilder::find_section_pieces() {
  const std::span<const RegionCorner> corners = arrangement_.corners();
  const std::span<const StripCrossing> crossings = arrangement_.crossings();
  upper_pieces_.clear();
  lower_pieces_.clear();
  first_upper_.clear();
  first_lower_.clear();
  std::size_t crossing = 0;
  for (std::uint32_t edge = 0; edge < corners.size(); ++edge) {
    const std::size_t first_crossing = crossing;
    while (crossing < crossings.size() && crossings[crossing].region_edge == edge) ++crossing;
    const std::uint32_t next = corners[edge].next;
    const auto pair_level = [&](std::int8_t level, std::vector<Piece>& pieces) {
      const bool is_upper = level > 0;
      mark(0.0, (is_upper ? upper_corner_ : lower_corner_)[edge],
           is_upper ? corners[edge].windings_above : corners[edge].windings_below);
      mark(1.0, (is_upper ? upper_corner_ : lower_corner_)[next],
           is_upper ? -corners[next].windings_above : -corners[next].windings_below);
      for (std::size_t i = first_crossing; i < crossing; ++i) {
        if (contact_.edges[crossings[i].strip_edge].level != level) continue;
        mark(crossings[i].region_share, first_crossing_point_ + static_cast<std::uint32_t>(i),
             level * crossings[i].entry);
      }
      return pair_marks(pieces);
    };
    first_upper_.push_back(static_cast<std::uint32_t>(upper_pieces_.size()));
    first_lower_.push_back(static_cast<std::uint32_t>(lower_pieces_.size()));
    if (!pair_level(1, upper_pieces_) || !pair_level(-1, lower_pieces_)) return false;
  }
  first_upper_.push_back(static_cast<std::uint32_t>(upper_pieces_.size()));
  first_lower_.push_back(static_cast<std::uint32_t>(lower_pieces_.size()));
  return true;
}

/// The parts inside the bone of the upright line in each region corner, from below to above.
bool PatchBuilder::find_uprights() {
  const std::span<const RegionCorner> corners = arrangement_.corners();
  const std::span<const CornerHit> hits = arrangement_.hits();
  uprights_.clear();
  first_upright_.clear();
  const auto half =
      static_cast<double>(contact_.lattice.snap_height(0.5 * contact_.plane.thickness_mm));
  std::size_t hit = 0;
  for (std::uint32_t corner = 0; corner < corners.size(); ++corner) {
    first_upright_.push_back(static_cast<std::uint32_t>(uprights_.size()));
    mark(-half, lower_corner_[corner], corners[corner].windings_below);
    mark(half, upper_corner_[corner], -corners[corner].windings_above);
    for (; hit < hits.size() && hits[hit].corner == corner; ++hit) {
      const std::uint32_t point = first_hit_point_ + static_cast<std::uint32_t>(hit);
      mark(static_cast<double>(corners_[point].height), point,
           -contact_.triangles[hits[hit].triangle].facing);
    }
    if (!pair_marks(uprights_)) return false;
  }
  first_upright_.push_back(static_cast<std::uint32_t>(uprights_.size()));
  return true;
}

bool PatchBuilder::fill(FaceView view, const FaceSource& source) {
  face_.clear();
  if (!filler_.fill(corners_, view, face_)) return false;
  for (const Triangle& triangle : face_) push_triangle(triangle, source);
  return true;
}

/// Seen from the region: up at the edge's beginning, along the upper plane, down at its end, back
/// along the lower plane.
bool PatchBuilder::add_front(std::uint32_t region_edge) {
  const std::uint32_t next = arrangement_.corners()[region_edge].next;
  filler_.begin();
  for (std::uint32_t i = first_upright_[region_edge]; i < first_upright_[region_edge + 1]; ++i) {
    filler_.add(uprights_[i].from, uprights_[i].to);
  }
  for (std::uint32_t i = first_upper_[region_edge]; i < first_upper_[region_edge + 1]; ++i) {
    filler_.add(upper_pieces_[i].from, upper_pieces_[i].to);
  }
  for (std::uint32_t i = first_upright_[next]; i < first_upright_[next + 1]; ++i) {
    filler_.add(uprights_[i].to, uprights_[i].from);
  }
  for (std::uint32_t i = first_lower_[region_edge]; i < first_lower_[region_edge + 1]; ++i) {
    filler_.add(lower_pieces_[i].to, lower_pieces_[i].from);
  }
  for (std::uint32_t i = newest_cut_of_[region_edge]; i != no_index; i = cuts_[i].next_of_edge) {
    filler_.add(cuts_[i].piece.to, cuts_[i].piece.from);
  }
  return filler_.is_empty() || fill(view_of_front(region_edge), {contact_.kerf, 0});
}

FaceView PatchBuilder::view_of_front(std::uint32_t region_edge) const noexcept {
  const std::span<const RegionCorner> corners = arrangement_.corners();
  const LatticePoint& r = corners[region_edge].place;
  const LatticePoint& s = corners[corners[region_edge].next].place;
  return view_along(Vec3(static_cast<double>(r.v - s.v), static_cast<double>(s.u - r.u), 0.0));
}

/// What the region takes of the section on one plane. The upper wall looks down and the lower one
/// up.
bool PatchBuilder::add_wall(std::int8_t level) {
  filler_.begin();
  for (std::uint32_t i = 0; i < contact_.edges.size(); ++i) {
    if (contact_.edges[i].level != level) continue;
    for_pieces(i, true, [this](std::uint32_t from, std::uint32_t to) { filler_.add(from, to); });
  }
  for (const Piece& piece : level > 0 ? upper_pieces_ : lower_pieces_) {
    if (level > 0) {
      filler_.add(piece.to, piece.from);
    } else {
      filler_.add(piece.from, piece.to);
    }
  }
  return fill(level > 0 ? FaceView::VU : FaceView::UV, {contact_.kerf, level});
}

}  // namespace hallux::simulator
