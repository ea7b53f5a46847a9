/// The faces that a region leaves inside the bone: fronts along its outline, walls on the kerf's two planes.
#include <algorithm>
#include <utility>

#include "simulator/cutting/solid/solid_patch.h"

namespace hallux::simulator {

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

bool PatchBuilder::fill(FaceView view, const FaceOrigin& origin) {
  face_.clear();
  if (!filler_.fill(corners_, view, face_)) return false;
  for (const Triangle& triangle : face_) push_triangle(triangle, origin);
  return true;
}

/// Seen from the region: up at the edge's beginning, along the upper plane, down at its end, back along the lower plane.
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

/// What the region takes of the section on one plane. The upper wall looks down and the lower one up.
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
