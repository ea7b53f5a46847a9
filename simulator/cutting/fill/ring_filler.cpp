#include "simulator/cutting/fill/ring_filler.h"

#include <cmath>
#include <utility>

namespace hallux::simulator {

namespace {

LatticePoint seen(const LatticeCorner& corner, FaceView view) noexcept {
  const std::int64_t u = corner.place.u, v = corner.place.v, z = corner.height;
  switch (view) {
    case FaceView::UV:
      return {u, v};
    case FaceView::VU:
      return {v, u};
    case FaceView::VZ:
      return {v, z};
    case FaceView::ZV:
      return {z, v};
    case FaceView::ZU:
      return {z, u};
    case FaceView::UZ:
      return {u, z};
  }
  return {u, v};
}

}  // namespace

FaceView view_along(const Vec3& normal_in_kerf) noexcept {
  const double u = std::abs(normal_in_kerf.x), v = std::abs(normal_in_kerf.y),
               z = std::abs(normal_in_kerf.z);
  if (z >= u && z >= v) return normal_in_kerf.z > 0.0 ? FaceView::UV : FaceView::VU;
  if (u >= v) return normal_in_kerf.x > 0.0 ? FaceView::VZ : FaceView::ZV;
  return normal_in_kerf.y > 0.0 ? FaceView::ZU : FaceView::UZ;
}

void RingFiller::begin() {
  for (const Edge& edge : edges_) edge_from_[edge.from] = no_index;
  edges_.clear();
}

bool RingFiller::fill(std::span<const LatticeCorner> corners, FaceView view,
                      std::vector<Triangle>& triangles) {
  if (edges_.empty()) return true;
  if (!link_rings(corners.size())) return false;
  if (ring_ends_.size() == 1) {
    fill_single(corners, view, triangles);
  } else {
    fill_several(corners, view, triangles);
  }
  return true;
}

bool RingFiller::link_rings(std::size_t corner_count) {
  if (edge_from_.size() < corner_count) edge_from_.resize(2 * corner_count, no_index);
  for (std::uint32_t i = 0; i < edges_.size(); ++i) {
    edges_[i].next_from = std::exchange(edge_from_[edges_[i].from], i);
  }
  ring_points_.clear();
  ring_ends_.clear();
  for (std::uint32_t i = 0; i < edges_.size(); ++i) {
    if (!edges_[i].is_used && !walk_ring(i)) return false;
  }
  return true;
}

std::uint32_t RingFiller::take_edge_from(std::uint32_t point) {
  std::uint32_t edge = edge_from_[point];
  while (edge != no_index && edges_[edge].is_used) edge = edges_[edge].next_from;
  if (edge != no_index) edges_[edge].is_used = true;
  return edge;
}

bool RingFiller::walk_ring(std::uint32_t first) {
  const std::uint32_t start = edges_[first].from;
  edges_[first].is_used = true;
  for (std::uint32_t edge = first; edge != no_index; edge = take_edge_from(edges_[edge].to)) {
    ring_points_.push_back(edges_[edge].from);
    if (edges_[edge].to != start) continue;
    ring_ends_.push_back(static_cast<std::uint32_t>(ring_points_.size()));
    return true;
  }
  return false;
}

void RingFiller::fill_single(std::span<const LatticeCorner> corners, FaceView view,
                             std::vector<Triangle>& triangles) {
  if (ring_points_.size() == 3) {
    triangles.push_back({ring_points_[0], ring_points_[1], ring_points_[2]});
    return;
  }
  places_.clear();
  for (const std::uint32_t point : ring_points_) places_.push_back(seen(corners[point], view));
  const std::size_t first = triangles.size();
  triangulator_.fill_loop(places_, triangles);
  name_corners(triangles, first);
}

void RingFiller::fill_several(std::span<const LatticeCorner> corners, FaceView view,
                              std::vector<Triangle>& triangles) {
  places_.clear();
  for (const std::uint32_t point : ring_points_) places_.push_back(seen(corners[point], view));
  loops_.resize(ring_ends_.size());
  std::uint32_t at = 0;
  for (std::size_t ring = 0; ring < ring_ends_.size(); ++ring) {
    loops_[ring].clear();
    for (; at < ring_ends_[ring]; ++at) loops_[ring].push_back(at);
  }
  const std::size_t first = triangles.size();
  triangulator_.fill_loops(places_, loops_, triangles);
  name_corners(triangles, first);
}

/// From places in the rings to points. Where rings pass a point twice, a triangle may name it
/// twice: its sides cancel, and no half-edge mesh holds it.
void RingFiller::name_corners(std::vector<Triangle>& triangles, std::size_t first) const {
  std::size_t kept = first;
  for (std::size_t i = first; i < triangles.size(); ++i) {
    Triangle named = triangles[i];
    for (std::uint32_t& corner : named) corner = ring_points_[corner];
    if (named[0] == named[1] || named[1] == named[2] || named[2] == named[0]) continue;
    triangles[kept++] = named;
  }
  triangles.resize(kept);
}

}  // namespace hallux::simulator
