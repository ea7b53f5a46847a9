#include "simulator/bone/cut_bone.h"

#include <algorithm>
#include <utility>

#include "simulator/base/check.h"

namespace hallux::simulator {

namespace {

const Bvh& tree_over(const CutSolid& solid, std::unique_ptr<const Bvh>& bvh) {
  if (!bvh) bvh = std::make_unique<const Bvh>(solid.mesh);
  return *bvh;
}

/// A kerf that opened nothing leaves the solid as it is, and so does one that comes when no bone is
/// left.
bool takes_nothing(const CutSolid& solid, const OpenedKerf& kerf) noexcept {
  return kerf.region.corners_mm.empty() || solid.mesh.triangles.empty();
}

KerfCut cut_one(const SolidWithTree& stands, const OpenedKerf& kerf) {
  return cut_kerf(stands.solid, stands.bvh, kerf.plane, kerf.number, kerf.grid, kerf.region);
}

}  // namespace

void CutBone::put_kerf(std::int32_t place, OpenedKerf kerf) {
  CHECK(place >= 0 && place <= kerf_count());
  grown_ = index(place);
  if (stages_.size() > grown_) stages_.resize(grown_);
  if (place == kerf_count()) {
    kerfs_.push_back(std::move(kerf));
  } else {
    kerfs_[grown_] = std::move(kerf);
  }
}

void CutBone::move_last(std::int32_t place) {
  CHECK(place >= 0 && place < kerf_count());
  if (stages_.size() > index(place)) stages_.resize(index(place));
  const auto moved = kerfs_.begin() + place;
  std::rotate(moved, moved + 1, kerfs_.end());
  grown_ = kerfs_.size() - 1;
}

const CutSolid& CutBone::kept_after(std::size_t count) const noexcept {
  return count == 0 ? whole_->solid : *stages_[count - 1].solid;
}

SolidWithTree CutBone::with_tree_after(std::size_t count) {
  if (count == 0) return {whole_->solid, whole_->tree};
  Stage& stage = stages_[count - 1];
  return {*stage.solid, tree_over(*stage.solid, stage.bvh)};
}

const CutSolid& CutBone::solid_before(std::int32_t place) {
  CHECK(place >= 0 && place <= kerf_count());
  std::size_t kept = std::min(index(place), stages_.size());
  while (kept > 0 && !stages_[kept - 1].solid) --kept;
  for (; kept < index(place); ++kept) cut_next(kept);
  forget_all_but(index(place));
  return kept_after(index(place));
}

void CutBone::cut_next(std::size_t place) {
  const OpenedKerf& next = kerfs_[place];
  KerfCut cut;
  if (const CutSolid& last = kept_after(place); takes_nothing(last, next)) {
    cut.solid = last;
  } else {
    cut = cut_one(with_tree_after(place), next);
  }
  if (place == stages_.size()) stages_.emplace_back();
  stages_[place].tally = cut;
  stages_[place].solid = std::move(cut.solid);
  forget_all_but(place + 1);
}

/// A solid after so many kerfs, and that from which the kerf that grew last is cut, are kept. Trees
/// are several times as large as their solids: of the two the one that the next cut needs.
void CutBone::forget_all_but(std::size_t count) noexcept {
  for (std::size_t after = 1; after <= stages_.size(); ++after) {
    if (after == count || after == grown_) continue;
    stages_[after - 1].solid.reset();
    stages_[after - 1].bvh.reset();
  }
}

SolidWithTree CutBone::before(std::int32_t place) {
  solid_before(place);
  return with_tree_after(index(place));
}

const KerfTally& CutBone::cut(std::int32_t place) {
  if (stages_.size() <= index(place)) solid_before(place + 1);
  return stages_[index(place)].tally;
}

const CutSolid& CutBone::after_all() { return solid_before(kerf_count()); }

CutSolid CutBone::all_but(std::int32_t place) {
  if (place < 0) return after_all();
  CutSolid solid = solid_before(place);
  for (std::int32_t later = place + 1; later < kerf_count(); ++later) {
    const OpenedKerf& kerf = kerfs_[index(later)];
    if (takes_nothing(solid, kerf)) continue;
    const Bvh bvh(solid.mesh);
    solid = cut_one({solid, bvh}, kerf).solid;
  }
  return solid;
}

}  // namespace hallux::simulator
