#include "simulator/cutting/field/kerf_set.h"

#include <cmath>

namespace hallux::simulator {

KerfSet::KerfSet(const Tray& tray, const FragmentPoses& fragments, const FieldGrid& grid)
    : tray_(tray),
      blade_(tray.first_saw().blade),
      fragments_(fragments),
      planes_(index(kerf_limit)),
      kerf_from_bone_(index(kerf_limit)),
      pool_(std::make_unique<TilePool>(index(kerf_limit) * KerfField::tiles_of(grid),
                                       KerfField::closed_mm(grid))) {
  fields_.reserve(index(kerf_limit));
  for (std::int32_t kerf = 0; kerf < kerf_limit; ++kerf) fields_.emplace_back(grid, *pool_);
}

bool KerfSet::apply(const CutEvent& event) noexcept {
  switch (event.kind) {
    case CutEventKind::PlaneFrozen:
      return event.subject == count_ && event.value >= 0 && event.value < fragments_.count() &&
             freeze(event.pose, static_cast<std::int32_t>(event.value)) >= 0;
    case CutEventKind::ToolChosen:
      return choose(event.subject);
    case CutEventKind::FragmentParted:
      if (!fragments_.apply(event)) return false;
      // Both sides are new solids: what the kerfs opened is in their surfaces.
      part_cuts(static_cast<std::int32_t>(event.value));
      kerfs_of_[index(static_cast<std::int32_t>(event.value))] = {};
      return true;
    case CutEventKind::Released:
      if (!fragments_.apply(event)) return false;
      part_cuts(event.subject);
      return true;
    default:
      return fragments_.apply(event);
  }
}

bool KerfSet::choose(std::int32_t tool) noexcept {
  if (!tray_.has(tool)) return false;
  tool_ = tool;
  if (const Saw* const saw = tray_.saw(tool)) blade_ = saw->blade;
  return true;
}

std::int32_t KerfSet::freeze(const QuantisedPose& fragment_from_tool,
                             std::int32_t fragment) noexcept {
  if (count_ == kerf_limit) return -1;
  const std::int32_t kerf = count_++;
  planes_[index(kerf)] = {transform_from(fragment_from_tool), blade_.kerf_mm};
  kerf_from_bone_[index(kerf)] = inverse(planes_[index(kerf)].bone_from_kerf);
  fragment_of_[index(kerf)] = fragment;
  kerfs_of_[index(fragment)].add(kerf);
  const bool is_one_cut = last_kerf_ >= 0 && fragment_of_[index(last_kerf_)] != fragment;
  cut_of_[index(kerf)] = is_one_cut ? cut_of_[index(last_kerf_)] : kerf;
  return kerf;
}

KerfNumbers KerfSet::one_cut_with(std::int32_t kerf) const noexcept {
  KerfNumbers kerfs;
  for (std::int32_t other = 0; other < count_; ++other) {
    if (cut_of_[index(other)] == cut_of_[index(kerf)]) kerfs.add(other);
  }
  return kerfs;
}

/// Each kerf of the fragment is a cut of its own from now on.
void KerfSet::part_cuts(std::int32_t fragment) noexcept {
  for (std::int32_t kerf = 0; kerf < count_; ++kerf) {
    if (fragment_of_[index(kerf)] != fragment) continue;
    const KerfNumbers others = one_cut_with(kerf);
    cut_of_[index(kerf)] = kerf;
    std::int32_t first = -1;
    for (const std::int32_t other : others) {
      if (other == kerf) continue;
      if (first < 0) first = other;
      cut_of_[index(other)] = first;
    }
  }
}

std::span<const RisenKerf> KerfSet::apply(const ToolSample& sample) noexcept {
  risen_count_ = 0;
  const bool cuts =
      sample.kerf >= 0 && sample.kerf < count_ && has(sample.status, ToolStatus::SawOn);
  if (!cuts) {
    last_kerf_ = -1;
    stamped_ = {};
    return {};
  }
  const KerfNumbers before = sample.kerf == last_kerf_ ? stamped_ : KerfNumbers{};
  const RigidTransform world_from_tool = transform_from(sample.world_from_tool);
  stamped_ = one_cut_with(sample.kerf);
  stamp(sample.kerf, world_from_tool, before.has(sample.kerf));
  for (const std::int32_t kerf : stamped_) {
    if (kerf != sample.kerf) stamp(kerf, world_from_tool, before.has(kerf));
  }
  last_kerf_ = sample.kerf;
  return {risen_.data(), risen_count_};
}

void KerfSet::stamp(std::int32_t kerf, const RigidTransform& world_from_tool,
                    bool goes_on) noexcept {
  const FragmentPose& fragment = fragments_[fragment_of_[index(kerf)]];
  const PlanarPose pose =
      planar_pose(planes_[index(kerf)], fragment.fragment_from_world * world_from_tool);
  FieldWindow changed;
  fields_[index(kerf)].stamp(blade_, goes_on ? last_poses_[index(kerf)] : pose, pose, changed);
  last_poses_[index(kerf)] = pose;
  if (!changed.is_empty()) risen_[risen_count_++] = {kerf, changed};
}

bool KerfSet::is_open(const KerfNumbers& kerfs, const Vec3& point_mm) const noexcept {
  for (const std::int32_t kerf : kerfs) {
    const Vec3 local = transform_point(kerf_from_bone_[index(kerf)], point_mm);
    const bool in_slab = std::abs(local.z) <= 0.5 * planes_[index(kerf)].thickness_mm;
    if (in_slab && fields_[index(kerf)].is_open(Vec2{local.x, local.y})) return true;
  }
  return false;
}

}  // namespace hallux::simulator
