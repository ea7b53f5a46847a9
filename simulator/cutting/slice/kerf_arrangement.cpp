/// Crossings are asked edge by edge on integers; states are carried, not asked: from the first
/// point of a skin along its tree, from the first corner of a loop along its edges, each crossing
/// adding its sign. A state other than in and out, or a loop that does not come back to its
/// beginning, refuses the region. Along one edge entries and exits are sorted apart and dealt out
/// in turn, so two crossings that rounding has exchanged cannot open the solid.
#include "simulator/cutting/slice/kerf_arrangement.h"

#include <algorithm>
#include <utility>

namespace hallux::simulator {

KerfArrangement::KerfArrangement(const SlabSlice& contact)
    : contact_(contact),
      search_(contact),
      asked_by_(contact.edges.size(), no_index),
      newest_on_(contact.edges.size(), no_index),
      net_entries_(contact.edges.size(), 0),
      chains_(contact.edges.size()),
      is_open_(contact.points.size(), 0),
      is_reached_(contact.skin_count, 0) {}

bool KerfArrangement::arrange(const RegionOutline& region) {
  take_region(region);
  find_crossings();
  if (!open_points() || !order_chains()) return false;
  find_hits();
  if (!wind_corners()) return false;
  mark_reached();
  return true;
}

void KerfArrangement::take_region(const RegionOutline& region) {
  corners_.clear();
  loop_starts_.clear();
  std::uint32_t first = 0;
  for (const std::uint32_t end : region.loop_ends) {
    add_loop({region.corners_mm.data() + first, end - first});
    first = end;
  }
}

/// Corners that fall on the same lattice point are one; a loop of fewer than three encloses
/// nothing.
void KerfArrangement::add_loop(std::span<const Vec2> loop_mm) {
  const std::size_t start = corners_.size();
  for (const Vec2& corner_mm : loop_mm) {
    const LatticePoint place = contact_.lattice.snap(corner_mm);
    if (corners_.size() > start && corners_.back().place == place) continue;
    corners_.push_back({place, corner_mm});
  }
  while (corners_.size() > start + 1 && corners_.back().place == corners_[start].place) {
    corners_.pop_back();
  }
  if (corners_.size() < start + 3) {
    corners_.resize(start);
    return;
  }
  loop_starts_.push_back(static_cast<std::uint32_t>(start));
  for (std::size_t i = start; i < corners_.size(); ++i) {
    const std::size_t next = i + 1 < corners_.size() ? i + 1 : start;
    corners_[i].next = static_cast<std::uint32_t>(next);
    corners_[next].before = static_cast<std::uint32_t>(i);
  }
}

void KerfArrangement::find_crossings() {
  for (const std::uint32_t edge : crossed_) {
    newest_on_[edge] = no_index;
    net_entries_[edge] = 0;
    chains_[edge] = {};
  }
  crossed_.clear();
  crossings_.clear();
  next_on_.clear();
  first_crossing_.clear();
  std::fill(asked_by_.begin(), asked_by_.end(), no_index);
  for (std::uint32_t i = 0; i < corners_.size(); ++i) {
    first_crossing_.push_back(static_cast<std::uint32_t>(crossings_.size()));
    search_.edges_near(corners_[i].place, corners_[corners_[i].next].place,
                       [&](std::uint32_t strip_edge) {
                         if (std::exchange(asked_by_[strip_edge], i) != i) {
                           try_crossing(strip_edge, i);
                         }
                       });
  }
  first_crossing_.push_back(static_cast<std::uint32_t>(crossings_.size()));
}

void KerfArrangement::try_crossing(std::uint32_t strip_edge, std::uint32_t region_edge) {
  const LatticePoint& a = contact_.points[contact_.edges[strip_edge].a].place;
  const LatticePoint& b = contact_.points[contact_.edges[strip_edge].b].place;
  const LatticePoint& r = corners_[region_edge].place;
  const LatticePoint& s = corners_[corners_[region_edge].next].place;
  const int side_of_r = side_of_corner(a, b, r);
  if (side_of_r == 0 || side_of_r == side_of_corner(a, b, s)) return;
  const int side_of_a = side_of_bone(r, s, a);
  if (side_of_a == side_of_bone(r, s, b)) return;
  const auto share = [](std::int64_t from, std::int64_t to) {
    return static_cast<double>(from) / static_cast<double>(from - to);
  };
  const auto index = static_cast<std::uint32_t>(crossings_.size());
  crossings_.push_back({strip_edge, region_edge, share(turn(r, s, a), turn(r, s, b)),
                        share(turn(a, b, r), turn(a, b, s)), static_cast<std::int8_t>(-side_of_a)});
  if (newest_on_[strip_edge] == no_index) crossed_.push_back(strip_edge);
  next_on_.push_back(newest_on_[strip_edge]);
  newest_on_[strip_edge] = index;
  net_entries_[strip_edge] -= side_of_a;
}

std::int32_t KerfArrangement::winding_around(const LatticePoint& bone) const noexcept {
  std::int32_t winding = 0;
  for (const RegionCorner& corner : corners_) {
    winding += winding_of_region_edge(corner.place, corners_[corner.next].place, bone);
  }
  return winding;
}

/// The first point of a skin is asked directly; from there the state changes with each crossing.
bool KerfArrangement::open_points() {
  for (const SlabSlice::TreeEdge& step : contact_.tree) {
    std::int32_t winding = 0;
    if (step.parent == no_index) {
      winding = winding_around(contact_.points[step.point].place);
    } else {
      const bool runs_along = contact_.edges[step.edge].a == step.parent;
      winding = is_open_[step.parent] + (runs_along ? 1 : -1) * net_entries_[step.edge];
    }
    if (winding != 0 && winding != 1) return false;
    is_open_[step.point] = static_cast<std::uint8_t>(winding);
  }
  return true;
}

bool KerfArrangement::order_chains() {
  chained_.clear();
  return std::all_of(crossed_.begin(), crossed_.end(),
                     [this](std::uint32_t edge) { return order_chain(edge); });
}

bool KerfArrangement::order_chain(std::uint32_t strip_edge) {
  entries_.clear();
  exits_.clear();
  for (std::uint32_t i = newest_on_[strip_edge]; i != no_index; i = next_on_[i]) {
    (crossings_[i].entry > 0 ? entries_ : exits_).push_back(i);
  }
  const auto is_earlier = [this](std::uint32_t i, std::uint32_t j) {
    return std::pair(crossings_[i].strip_share, i) < std::pair(crossings_[j].strip_share, j);
  };
  std::sort(entries_.begin(), entries_.end(), is_earlier);
  std::sort(exits_.begin(), exits_.end(), is_earlier);
  const StripEdge& edge = contact_.edges[strip_edge];
  const std::size_t opens_at_a = is_open_[edge.a], opens_at_b = is_open_[edge.b];
  if (entries_.size() + opens_at_a != exits_.size() + opens_at_b) return false;
  Chain& chain = chains_[strip_edge];
  chain.first = static_cast<std::uint32_t>(chained_.size());
  chain.count = static_cast<std::uint32_t>(entries_.size() + exits_.size());
  bool enters = opens_at_a == 0;
  for (std::size_t entry = 0, exit = 0; entry + exit < chain.count; enters = !enters) {
    chained_.push_back(enters ? entries_[entry++] : exits_[exit++]);
  }
  return true;
}

void KerfArrangement::find_hits() {
  hits_.clear();
  for (std::uint32_t i = 0; i < corners_.size(); ++i) {
    for (const std::uint32_t triangle : search_.triangles_near(corners_[i].place)) {
      try_hit(i, triangle);
    }
  }
}

void KerfArrangement::try_hit(std::uint32_t corner, std::uint32_t triangle) {
  const StripTriangle& asked = contact_.triangles[triangle];
  const LatticePoint& place = corners_[corner].place;
  std::array<LatticePoint, 3> at;
  for (std::size_t k = 0; k < 3; ++k) at[k] = contact_.points[asked.points[k]].place;
  for (std::size_t k = 0; k < 3; ++k) {
    if (side_of_corner(at[k], at[(k + 1) % 3], place) != asked.facing) return;
  }
  CornerHit hit{corner, triangle, {}};
  const auto whole = static_cast<double>(turn(at[0], at[1], at[2]));
  for (std::size_t k = 0; k < 3; ++k) {
    hit.weights[k] = static_cast<double>(turn(at[(k + 1) % 3], at[(k + 2) % 3], place)) / whole;
  }
  hits_.push_back(hit);
}

void KerfArrangement::wind_first(RegionCorner& corner) const {
  corner.windings_above = corner.windings_below = 0;
  const LatticePoint& place = corner.place;
  const bool is_far = place.u < contact_.min.u || place.u > contact_.max.u ||
                      place.v < contact_.min.v || place.v > contact_.max.v;
  if (is_far) return;
  for (const StripEdge& edge : contact_.edges) {
    if (edge.level == 0) continue;
    const std::int32_t winding =
        winding_of_bone_edge(contact_.points[edge.a].place, contact_.points[edge.b].place, place);
    if (edge.level > 0) corner.windings_above -= winding;
    if (edge.level < 0) corner.windings_below += winding;
  }
}

/// What the windings are behind the region edge that begins in this corner.
std::array<std::int32_t, 2> KerfArrangement::windings_behind(std::uint32_t region_edge) const {
  std::int32_t above = corners_[region_edge].windings_above;
  std::int32_t below = corners_[region_edge].windings_below;
  for (std::uint32_t i = first_crossing_[region_edge]; i < first_crossing_[region_edge + 1]; ++i) {
    const std::int8_t level = contact_.edges[crossings_[i].strip_edge].level;
    if (level > 0) above += crossings_[i].entry;
    if (level < 0) below -= crossings_[i].entry;
  }
  return {above, below};
}

/// The first corner of a loop is asked directly; along the loop the state changes with each contour
/// edge crossed.
bool KerfArrangement::wind_corners() {
  for (const std::uint32_t start : loop_starts_) {
    wind_first(corners_[start]);
    std::uint32_t at = start;
    for (; corners_[at].next != start; at = corners_[at].next) {
      RegionCorner& next = corners_[corners_[at].next];
      const auto [above, below] = windings_behind(at);
      next.windings_above = above;
      next.windings_below = below;
    }
    const auto [above, below] = windings_behind(at);
    const RegionCorner& first = corners_[start];
    if (above != first.windings_above || below != first.windings_below) return false;
  }
  return true;
}

void KerfArrangement::mark_reached() {
  std::fill(is_reached_.begin(), is_reached_.end(), std::uint8_t{0});
  const auto mark = [this](std::uint32_t touched) {
    is_reached_[contact_.touched[touched].skin] = 1;
  };
  for (const SlabSlice::TreeEdge& step : contact_.tree) {
    if (is_open_[step.point] != 0) is_reached_[step.skin] = 1;
  }
  for (const StripCrossing& crossing : crossings_) {
    mark(contact_.edges[crossing.strip_edge].touched);
  }
  for (const CornerHit& hit : hits_) mark(contact_.triangles[hit.triangle].touched);
}

bool KerfArrangement::takes_section() const noexcept {
  const bool is_cut_short = !crossings_.empty() || !hits_.empty() ||
                            std::any_of(corners_.begin(), corners_.end(), [](const auto& corner) {
                              return corner.windings_above != 0 || corner.windings_below != 0;
                            });
  return !is_cut_short && std::any_of(is_open_.begin(), is_open_.end(),
                                      [](std::uint8_t is_open) { return is_open != 0; });
}

}  // namespace hallux::simulator
