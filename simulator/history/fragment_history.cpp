/// A kerf grows on a solid whose other kerfs stand still: so a span falls into stretches, one mesh
/// each, and any moment is a stretch and a threshold of its field. What was taken out is drawn no
/// more by the triangles that lie on its body, and by those that kerfs make within it afterwards.
#include "simulator/history/fragment_history.h"

#include <algorithm>
#include <utility>

namespace hallux::simulator {

namespace {

/// Where the growth passes from one kerf to another.
struct Turn {
  std::int64_t tick = 0;
  std::int32_t kerf = -1;
};

/// At each tick the blade is in one kerf of the fragment.
std::vector<Turn> turns_of(const FragmentSpan& span, const std::vector<KerfGrowth>& growths) {
  std::vector<Turn> grown;
  for (const std::int32_t kerf : span.kerfs) {
    for (const std::int32_t tick : growths[static_cast<std::size_t>(kerf)].ticks)
      if (tick < span.until_tick) grown.push_back({tick, kerf});
  }
  std::sort(grown.begin(), grown.end(),
            [](const Turn& a, const Turn& b) { return a.tick < b.tick; });
  const auto end = std::unique(grown.begin(), grown.end(),
                               [](const Turn& a, const Turn& b) { return a.kerf == b.kerf; });
  grown.erase(end, grown.end());
  if (grown.empty()) grown.push_back({span.from_tick, -1});
  grown.front().tick = span.from_tick;
  return grown;
}

std::vector<BoreRim> rims_on(const IndexedMesh& skin, const Bvh& tree, std::int32_t fragment,
                             std::int64_t until_tick, const std::vector<BoreGrowth>& bores) {
  std::vector<BoreRim> rims;
  for (std::size_t i = 0; i < bores.size(); ++i) {
    const BorePlace& place = bores[i].at_last;
    if (place.fragment != fragment || bores[i].from_tick >= until_tick) continue;
    for (HoleRim& rim : hole_rims(skin, tree, capsule_of(place.bore)))
      rims.push_back({i, std::move(rim), never_tick});
  }
  return rims;
}

std::vector<std::uint32_t> triangles_of(const TakenPiece& piece, const IndexedMesh& mesh) {
  std::vector<std::uint32_t> found;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    if (piece.has(middle_of(corners_of(mesh, i)))) found.push_back(static_cast<std::uint32_t>(i));
  }
  return found;
}

void mark_taken(BoneStretch& stretch, const std::vector<TakenPiece>& all) {
  for (std::size_t i = stretch.taken_before; i < all.size(); ++i) {
    const TakenPiece& taken = all[i];
    const bool is_seen = stretch.until_tick > taken.tick;
    stretch.of_piece.push_back(is_seen ? triangles_of(taken, stretch.solid.mesh)
                                       : std::vector<std::uint32_t>());
    if (!is_seen) continue;
    for (BoreRim& rim : stretch.rims) {
      if (taken.has(rim.rim.points_mm.front())) rim.gone_tick = std::min(rim.gone_tick, taken.tick);
    }
  }
}

/// What the stretches of one fragment are made from.
struct StretchWork {
  std::int32_t fragment = 0;
  const std::vector<KerfGrowth>& growths;
  const std::vector<BoreGrowth>& bores;
};

BoneStretch stretch_from(BoneAtTick& bone, const Turn& turn, std::int64_t until_tick,
                         const StretchWork& work) {
  BoneStretch stretch;
  stretch.from_tick = turn.tick;
  stretch.until_tick = until_tick;
  stretch.growing = turn.kerf;
  stretch.solid = bone.all_but(turn.kerf, turn.tick);
  if (turn.kerf < 0 && work.bores.empty()) return stretch;
  const Bvh tree(stretch.solid.mesh);
  stretch.rims = rims_on(stretch.solid.mesh, tree, work.fragment, until_tick, work.bores);
  if (turn.kerf < 0) return stretch;
  const OpenedField& opened = work.growths[static_cast<std::size_t>(turn.kerf)].opened;
  stretch.contact = std::make_unique<const SlabSlice>(
      slice_slab(stretch.solid, tree, opened.plane, turn.kerf, opened.grid));
  return stretch;
}

}  // namespace

std::size_t FragmentHistory::stretch_at(std::int64_t tick) const noexcept {
  std::size_t found = 0;
  for (std::size_t i = 1; i < stretches.size(); ++i)
    if (stretches[i].from_tick <= tick) found = i;
  return found;
}

void build_stretches(FragmentHistory& history, SpannedFragment spanned, std::int32_t fragment,
                     const std::vector<KerfGrowth>& growths, const std::vector<BoreGrowth>& bores,
                     const Progress& progress) {
  history.out_tick = spanned.out_tick;
  history.taken = std::move(spanned.taken);
  const StretchWork work{fragment, growths, bores};
  const auto span_share = 1.0 / static_cast<double>(std::max<std::size_t>(1, spanned.spans.size()));
  double done = 0.0;
  for (FragmentSpan& span : spanned.spans) {
    const std::vector<Turn> turns = turns_of(span, growths);
    BoneAtTick bone(*span.whole, NumberedPieces(span.whole->solid), growths, span.kerfs);
    for (std::size_t i = 0; i < turns.size(); ++i) {
      report(progress, done);
      done += span_share / static_cast<double>(turns.size());
      const std::int64_t until = i + 1 < turns.size() ? turns[i + 1].tick : span.until_tick;
      BoneStretch stretch = stretch_from(bone, turns[i], until, work);
      stretch.taken_before = span.taken_before;
      mark_taken(stretch, history.taken);
      history.stretches.push_back(std::move(stretch));
    }
  }
  if (!spanned.spans.empty()) history.whole = std::move(spanned.spans.back().whole);
}

}  // namespace hallux::simulator
