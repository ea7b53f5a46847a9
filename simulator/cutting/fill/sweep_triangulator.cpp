/// Corners are passed from left to right; two bits, whether the loop comes from the left and
/// whether it goes there, say what a corner does to the gaps: begin, part, end, join, or go on
/// along an edge. Anything that does not fit, an edge that is not there, a corner outside all gaps,
/// ends the sweep without triangles, and the ears are clipped instead.
#include "simulator/cutting/fill/sweep_triangulator.h"

#include <algorithm>
#include <tuple>

namespace hallux::simulator {

void SweepTriangulator::begin(std::span<const LatticePoint> points) {
  points_ = points;
  corners_.clear();
}

void SweepTriangulator::add_corner(std::uint32_t point, std::size_t i, std::size_t count) {
  const auto here = static_cast<std::uint32_t>(corners_.size());
  const auto others = static_cast<std::uint32_t>(count - 1);
  corners_.push_back(
      {point, i > 0 ? here - 1 : here + others, i + 1 < count ? here + 1 : here - others, none});
}

void SweepTriangulator::add_loop(std::span<const std::uint32_t> loop) {
  if (loop.size() < 3) return;
  for (std::size_t i = 0; i < loop.size(); ++i) add_corner(loop[i], i, loop.size());
}

void SweepTriangulator::add_loop_of_all() {
  if (points_.size() < 3) return;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    add_corner(static_cast<std::uint32_t>(i), i, points_.size());
  }
}

bool SweepTriangulator::is_earlier(std::uint32_t a, std::uint32_t b) const noexcept {
  const LatticePoint &p = at(a), &q = at(b);
  return std::tie(p.u, p.v, a) < std::tie(q.u, q.v, b);
}

bool SweepTriangulator::fill(std::vector<Triangle>& triangles) {
  order_.resize(corners_.size());
  for (std::uint32_t i = 0; i < corners_.size(); ++i) order_[i] = i;
  std::sort(order_.begin(), order_.end(),
            [this](std::uint32_t a, std::uint32_t b) { return is_earlier(a, b); });
  links_.clear();
  gaps_.clear();
  made_.clear();
  for (const std::uint32_t corner : order_) {
    if (!pass(corner)) return false;
  }
  triangles.insert(triangles.end(), made_.begin(), made_.end());
  return true;
}

bool SweepTriangulator::pass(std::uint32_t corner) {
  const bool comes_from_left = is_earlier(corners_[corner].before, corner);
  const bool goes_left = is_earlier(corners_[corner].behind, corner);
  if (comes_from_left) return goes_left ? end_or_join(corner) : go_on_below(corner);
  return goes_left ? go_on_above(corner) : begin_or_part(corner);
}

bool SweepTriangulator::begin_or_part(std::uint32_t corner) {
  const std::int64_t turns = turn_of(corners_[corner].before, corner, corners_[corner].behind);
  if (turns == 0) return false;
  if (turns > 0) {
    begin_gap(corner);
    return true;
  }
  const std::uint32_t gap = gap_around(corner);
  if (gap == none) return false;
  part_gap(corner, gap);
  return true;
}

bool SweepTriangulator::end_or_join(std::uint32_t corner) {
  const std::uint32_t lower = corners_[corner].gap, upper = corners_[corners_[corner].before].gap;
  if (lower == none || upper == none) return false;
  if (gaps_[lower].upper_edge != corner || gaps_[upper].lower_edge != corners_[corner].before) {
    return false;
  }
  if (lower == upper) return end_gap(corner, lower);
  join_gaps(corner, lower, upper);
  return true;
}

bool SweepTriangulator::go_on_below(std::uint32_t corner) {
  const std::uint32_t before = corners_[corner].before;
  const std::uint32_t gap = corners_[before].gap;
  if (gap == none || gaps_[gap].lower_edge != before) return false;
  const std::uint32_t above = cut_off_above(corner, gaps_[gap].lowest);
  gaps_[gap].lowest = gaps_[gap].latest = add_link(corner, none, above);
  set_edges(gap, corner, gaps_[gap].upper_edge);
  return true;
}

bool SweepTriangulator::go_on_above(std::uint32_t corner) {
  const std::uint32_t gap = corners_[corner].gap;
  if (gap == none || gaps_[gap].upper_edge != corner) return false;
  const std::uint32_t below = cut_off_below(corner, gaps_[gap].highest);
  gaps_[gap].highest = gaps_[gap].latest = add_link(corner, below, none);
  set_edges(gap, gaps_[gap].lower_edge, corners_[corner].before);
  return true;
}

void SweepTriangulator::begin_gap(std::uint32_t corner) {
  const std::uint32_t link = add_link(corner, none, none);
  gaps_.push_back({none, none, link, link, link});
  set_edges(static_cast<std::uint32_t>(gaps_.size() - 1), corner, corners_[corner].before);
}

/// The latest corner goes into both chains.
void SweepTriangulator::part_gap(std::uint32_t corner, std::uint32_t gap) {
  const Gap whole = gaps_[gap];
  const Link latest = links_[whole.latest];
  const std::uint32_t twin = add_link(latest.corner, none, latest.above);
  links_[whole.latest].above = none;
  const std::uint32_t below = cut_off_below(corner, whole.latest);
  const std::uint32_t above = cut_off_above(corner, twin);
  const std::uint32_t top = add_link(corner, below, none);
  const std::uint32_t bottom = add_link(corner, none, above);
  gaps_[gap].highest = gaps_[gap].latest = top;
  gaps_.push_back({none, none, bottom, latest.above == none ? twin : whole.highest, bottom});
  set_edges(static_cast<std::uint32_t>(gaps_.size() - 1), corner, whole.upper_edge);
  set_edges(gap, whole.lower_edge, corners_[corner].before);
}

void SweepTriangulator::join_gaps(std::uint32_t corner, std::uint32_t lower, std::uint32_t upper) {
  const std::uint32_t below = cut_off_below(corner, gaps_[lower].highest);
  const std::uint32_t above = cut_off_above(corner, gaps_[upper].lowest);
  gaps_[lower].highest = gaps_[upper].highest;
  gaps_[lower].latest = add_link(corner, below, above);
  gaps_[upper].is_open = false;
  set_edges(lower, gaps_[lower].lower_edge, gaps_[upper].upper_edge);
}

bool SweepTriangulator::end_gap(std::uint32_t corner, std::uint32_t gap) {
  gaps_[gap].is_open = false;
  for (std::uint32_t link = gaps_[gap].highest; links_[link].below != none;) {
    const std::uint32_t next = links_[link].below;
    if (turn_of(corner, links_[link].corner, links_[next].corner) < 0) return false;
    push(corner, links_[link].corner, links_[next].corner);
    link = next;
  }
  return true;
}

/// The gap that the corner lies in, strictly between its edges.
std::uint32_t SweepTriangulator::gap_around(std::uint32_t corner) const noexcept {
  const auto is_left_of = [&](std::uint32_t edge) {
    return turn_of(edge, corners_[edge].behind, corner) > 0;
  };
  for (std::uint32_t i = 0; i < gaps_.size(); ++i) {
    const Gap& gap = gaps_[i];
    if (gap.is_open && is_left_of(gap.lower_edge) && is_left_of(gap.upper_edge)) return i;
  }
  return none;
}

void SweepTriangulator::set_edges(std::uint32_t gap, std::uint32_t lower_edge,
                                  std::uint32_t upper_edge) {
  gaps_[gap].lower_edge = lower_edge;
  gaps_[gap].upper_edge = upper_edge;
  corners_[lower_edge].gap = corners_[upper_edge].gap = gap;
}

std::uint32_t SweepTriangulator::add_link(std::uint32_t corner, std::uint32_t below,
                                          std::uint32_t above) {
  const auto link = static_cast<std::uint32_t>(links_.size());
  links_.push_back({corner, below, above});
  if (below != none) links_[below].above = link;
  if (above != none) links_[above].below = link;
  return link;
}

/// Down the chain from `link`, as far as the corner sees; returns the first link that stays.
std::uint32_t SweepTriangulator::cut_off_below(std::uint32_t corner, std::uint32_t link) {
  for (std::uint32_t next = links_[link].below; next != none; next = links_[link].below) {
    if (turn_of(corner, links_[link].corner, links_[next].corner) <= 0) break;
    push(corner, links_[link].corner, links_[next].corner);
    link = next;
  }
  return link;
}

std::uint32_t SweepTriangulator::cut_off_above(std::uint32_t corner, std::uint32_t link) {
  for (std::uint32_t next = links_[link].above; next != none; next = links_[link].above) {
    if (turn_of(links_[next].corner, links_[link].corner, corner) <= 0) break;
    push(links_[next].corner, links_[link].corner, corner);
    link = next;
  }
  return link;
}

void SweepTriangulator::push(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  made_.push_back({corners_[a].point, corners_[b].point, corners_[c].point});
}

}  // namespace hallux::simulator
