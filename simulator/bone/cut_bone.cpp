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

KerfCut cut_nothing(const CutSolid& solid) {
  KerfCut nothing;
  nothing.solid = solid;
  return nothing;
}

}  // namespace

void CutBone::put_kerf(std::int32_t place, OpenedKerf kerf) {
  CHECK(place >= 0 && place <= kerf_count());
  if (stages_.size() > index(place)) stages_.resize(index(place));
  if (place == kerf_count()) {
    kerfs_.push_back(std::move(kerf));
  } else {
    kerfs_[index(place)] = std::move(kerf);
  }
}

void CutBone::move_last(std::int32_t place) {
  CHECK(place >= 0 && place < kerf_count());
  if (stages_.size() > index(place)) stages_.resize(index(place));
  const auto moved = kerfs_.begin() + place;
  std::rotate(moved, moved + 1, kerfs_.end());
}

SolidWithTree CutBone::stands() {
  if (stages_.empty()) return {whole_->solid, whole_->tree};
  Stage& last = stages_.back();
  return {last.cut.solid, tree_over(last.cut.solid, last.bvh)};
}

const CutSolid& CutBone::solid_before(std::int32_t place) {
  CHECK(place >= 0 && place <= kerf_count());
  while (stages_.size() < index(place)) {
    const OpenedKerf& next = kerfs_[stages_.size()];
    const CutSolid& last = stages_.empty() ? whole_->solid : stages_.back().cut.solid;
    stages_.push_back(
        {takes_nothing(last, next) ? cut_nothing(last) : cut_one(stands(), next), nullptr});
  }
  forget_trees_before(place - 1);
  return place == 0 ? whole_->solid : stages_[index(place) - 1].cut.solid;
}

/// A tree is several times as large as its solid, and a kerf that grows needs that of the solid
/// before it alone; others are built again where they are asked for. That of the whole bone, which
/// every attempt begins and most end with, stays.
void CutBone::forget_trees_before(std::int32_t place) noexcept {
  for (std::int32_t stage = 1; stage < place; ++stage) stages_[index(stage) - 1].bvh.reset();
}

SolidWithTree CutBone::before(std::int32_t place) {
  const CutSolid& solid = solid_before(place);
  if (place == 0) return {solid, whole_->tree};
  return {solid, tree_over(solid, stages_[index(place) - 1].bvh)};
}

const KerfCut& CutBone::cut(std::int32_t place) {
  solid_before(place + 1);
  return stages_[index(place)].cut;
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
