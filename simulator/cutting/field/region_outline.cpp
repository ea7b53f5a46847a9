#include "simulator/cutting/field/region_outline.h"

#include <span>

#include "simulator/base/check.h"
#include "simulator/cutting/field/outline_path.h"

namespace hallux::simulator {

namespace {

// Room for what a blade outlines: 200 mm pass about 160 tiles of 1.6 mm, each with some 40
// crossings.
constexpr std::size_t usual_tiles = 160;
constexpr std::size_t usual_crossings = 96;
constexpr std::size_t usual_chains = 8;
constexpr std::size_t usual_corners = 1024;

}  // namespace

OutlineTracker::OutlineTracker(const FieldGrid& grid)
    : grid_(grid), drawn_(usual_tiles), tile_rows_(KerfField::tiles_over(grid.v_count)) {
  const auto columns = static_cast<std::size_t>(KerfField::tiles_over(grid.u_count));
  seen_.resize(columns * static_cast<std::size_t>(tile_rows_));
  place_of_.assign(seen_.size(), -1);
  for (std::size_t i = usual_tiles; i-- > 0;) {
    drawn_[i].reserve(usual_crossings, usual_chains);
    spare_.push_back(static_cast<std::int32_t>(i));
  }
  chains_.reserve(usual_tiles * 2);
  loop_.reserve(usual_tiles * usual_crossings / 2);
  outline_.corners_mm.reserve(usual_corners);
  outline_.loop_ends.reserve(usual_chains);
}

void OutlineTracker::update(const KerfField& field) {
  const std::vector<std::uint32_t>& revisions = field.tile_revisions();
  CHECK(revisions.size() == seen_.size() && field.grid().v_count == grid_.v_count);
  bool is_changed = false;
  for (std::size_t tile = 0; tile < seen_.size(); ++tile) {
    if (revisions[tile] == seen_[tile]) continue;
    contour_tile(field, tile);
    seen_[tile] = revisions[tile];
    is_changed = true;
  }
  if (is_changed) link_loops();
}

void OutlineTracker::contour_tile(const KerfField& field, std::size_t tile) {
  std::int32_t& place = place_of_[tile];
  if (place < 0) {
    if (spare_.empty()) {
      spare_.push_back(static_cast<std::int32_t>(drawn_.size()));
      drawn_.emplace_back();
    }
    place = spare_.back();
    spare_.pop_back();
  }
  const auto index = static_cast<std::int32_t>(tile);
  drawn(tile).contour(field, index / tile_rows_, index % tile_rows_);
  if (!drawn(tile).chains().empty()) return;
  spare_.push_back(place);
  place = -1;
}

/// Chains in the order of tiles, and within a tile in its own: both depend on the field alone.
void OutlineTracker::link_loops() {
  outline_.corners_mm.clear();
  outline_.loop_ends.clear();
  ++linkings_;
  for (std::size_t tile = 0; tile < place_of_.size(); ++tile) {
    if (place_of_[tile] < 0) continue;
    const std::vector<OutlineChain>& chains = drawn(tile).chains();
    for (std::size_t chain = 0; chain < chains.size(); ++chain) {
      if (chains[chain].linked_in != linkings_) append_loop({tile, chain});
    }
  }
}

void OutlineTracker::append_loop(ChainRef start) {
  chains_.clear();
  std::size_t furthest = 0;
  for (ChainRef at = start;; at = next_of(at)) {
    OutlineChain& chain = chain_at(at);
    if (chain.linked_in == linkings_) break;
    chain.linked_in = linkings_;
    if (!chains_.empty() && chain.along_mm > chain_at(chains_[furthest]).along_mm) {
      furthest = chains_.size();
    }
    chains_.push_back(at);
  }
  // From the loop's furthest crossing around to it.
  loop_.clear();
  const OutlineChain& first = chain_at(chains_[furthest]);
  append_crossings(chains_[furthest].tile, first.furthest, first.last);
  for (std::size_t i = 1; i < chains_.size(); ++i) {
    const ChainRef& at = chains_[(furthest + i) % chains_.size()];
    append_crossings(at.tile, chain_at(at).first, chain_at(at).last);
  }
  append_crossings(chains_[furthest].tile, first.first, first.furthest);
  append_straightened(loop_, outline_.corners_mm);
  outline_.loop_ends.push_back(static_cast<std::uint32_t>(outline_.corners_mm.size()));
}

/// The chain that goes on where this one leaves its tile; itself where it is closed.
OutlineTracker::ChainRef OutlineTracker::next_of(const ChainRef& at) noexcept {
  const OutlineChain& chain = chain_at(at);
  if (chain.is_closed) return at;
  const auto rows = static_cast<std::size_t>(tile_rows_);
  ChainRef next{at.tile, 0};
  switch (chain.exit.side) {
    case CellSide::Bottom:
      next.tile -= 1;
      break;
    case CellSide::Right:
      next.tile += rows;
      break;
    case CellSide::Top:
      next.tile += 1;
      break;
    case CellSide::Left:
      next.tile -= rows;
      break;
  }
  CHECK(next.tile < place_of_.size() && place_of_[next.tile] >= 0);
  const TileGate entry{opposite(chain.exit.side), chain.exit.place};
  const std::vector<OutlineChain>& chains = drawn(next.tile).chains();
  while (next.chain < chains.size() &&
         (chains[next.chain].is_closed || chains[next.chain].entry != entry)) {
    ++next.chain;
  }
  CHECK(next.chain < chains.size());
  return next;
}

void OutlineTracker::append_crossings(std::size_t tile, std::uint32_t first, std::uint32_t last) {
  const auto begin = drawn(tile).crossings().begin();
  loop_.insert(loop_.end(), begin + first, begin + last);
}

std::vector<std::vector<Vec2>> loops_of(const RegionOutline& outline) {
  std::vector<std::vector<Vec2>> loops;
  std::uint32_t first = 0;
  for (const std::uint32_t end : outline.loop_ends) {
    const auto corners = std::span(outline.corners_mm).subspan(first, end - first);
    loops.emplace_back(corners.begin(), corners.end());
    first = end;
  }
  return loops;
}

RegionOutline outline_of(const KerfField& field) {
  OutlineTracker tracker(field.grid());
  tracker.update(field);
  return tracker.outline();
}

}  // namespace hallux::simulator
