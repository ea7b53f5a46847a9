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

KerfCut cut_one(const CutSolid& solid, std::unique_ptr<const Bvh>& bvh, const OpenedKerf& kerf) {
  if (!takes_nothing(solid, kerf)) {
    return cut_kerf(solid, tree_over(solid, bvh), kerf.plane, kerf.number, kerf.grid, kerf.region);
  }
  KerfCut nothing;
  nothing.solid = solid;
  return nothing;
}

}  // namespace

CutBone::CutBone(IndexedMesh whole)
    : whole_{{uncut_solid(std::move(whole)), 0.0, false, 0}, nullptr}, pieces_(whole_.cut.solid) {}

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

CutBone::Stage& CutBone::stage_before(std::int32_t place) {
  CHECK(place >= 0 && place <= kerf_count());
  while (stages_.size() < index(place)) {
    const OpenedKerf& next = kerfs_[stages_.size()];
    Stage& last = stages_.empty() ? whole_ : stages_.back();
    stages_.push_back({cut_one(last.cut.solid, last.bvh, next), nullptr});
  }
  forget_trees_before(place - 1);
  return place == 0 ? whole_ : stages_[index(place) - 1];
}

/// A tree is several times as large as its solid, and a kerf that grows needs that of the solid
/// before it alone; others are built again where they are asked for. That of the whole bone, which
/// every attempt begins and most end with, stays.
void CutBone::forget_trees_before(std::int32_t place) noexcept {
  for (std::int32_t stage = 1; stage < place; ++stage) stages_[index(stage) - 1].bvh.reset();
}

SolidWithTree CutBone::before(std::int32_t place) {
  Stage& stage = stage_before(place);
  return {stage.cut.solid, tree_over(stage.cut.solid, stage.bvh)};
}

const KerfCut& CutBone::cut(std::int32_t place) { return stage_before(place + 1).cut; }

const CutSolid& CutBone::after_all() { return stage_before(kerf_count()).cut.solid; }

CutSolid CutBone::all_but(std::int32_t place) {
  if (place < 0) return after_all();
  CutSolid solid = stage_before(place).cut.solid;
  for (std::int32_t later = place + 1; later < kerf_count(); ++later) {
    std::unique_ptr<const Bvh> bvh;
    solid = cut_one(solid, bvh, kerfs_[index(later)]).solid;
  }
  return solid;
}

}  // namespace hallux::simulator
