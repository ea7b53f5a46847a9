#include "simulator/history/bone_history.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "simulator/jobs/lying_bones.h"

namespace hallux::simulator {

namespace {

/// Of the whole work; the rest is stretches.
constexpr double spans_share = 0.3;

/// A place on the fragment that it came to be on, and its height above that.
struct NearPart {
  PlaceOnFragment place;
  double off_mm = std::numeric_limits<double>::infinity();
};

/// Of the fragment that a place is said on and those that were parted from it, the one whose solid
/// holds it, else the nearest. A fragment is parted from one of a lower number.
NearPart nearest_part(const std::vector<FragmentHistory>& fragments, const PlaceOnFragment& place) {
  NearPart nearest{place};
  std::vector<bool> is_of(fragments.size(), false);
  for (std::size_t i = 0; i < fragments.size(); ++i) {
    const std::int32_t parent = fragments[i].origin.parent;
    is_of[i] = static_cast<std::int32_t>(i) == place.fragment ||
               (parent >= 0 && is_of[static_cast<std::size_t>(parent)]);
    if (!is_of[i] || fragments[i].whole == nullptr) continue;
    const double off_mm = fragments[i].whole->tree.signed_distance_mm(place.point_mm);
    if (off_mm >= nearest.off_mm) continue;
    nearest = {{static_cast<std::int32_t>(i), place.point_mm}, off_mm};
  }
  return nearest;
}

}  // namespace

RigidTransform BoneHistory::world_from_fragment(std::int32_t fragment,
                                                std::int64_t tick) const noexcept {
  const FragmentHistory& history = fragments[static_cast<std::size_t>(fragment)];
  return history.path.world_from_fragment(
      tick, world_from_bones[static_cast<std::size_t>(history.origin.bone)]);
}

PlaceOnFragment BoneHistory::place_at_last(const PlaceOnFragment& place) const {
  return nearest_part(fragments, place).place;
}

PlaceOnFragment BoneHistory::place_at_last(const Vec3& point_in_first_mm) const {
  const Vec3 in_world_mm = transform_point(world_from_bones.front(), point_in_first_mm);
  NearPart nearest{{0, point_in_first_mm}};
  for (std::size_t bone = 0; bone < world_from_bones.size(); ++bone) {
    const Vec3 point_mm = transform_point(inverse(world_from_bones[bone]), in_world_mm);
    const NearPart part = nearest_part(fragments, {static_cast<std::int32_t>(bone), point_mm});
    if (part.off_mm < nearest.off_mm) nearest = part;
  }
  return nearest.place;
}

Vec3 BoneHistory::point_in_first_mm(const PlaceOnFragment& place) const noexcept {
  const std::int32_t bone = fragments[static_cast<std::size_t>(place.fragment)].origin.bone;
  if (bone == 0) return place.point_mm;
  const RigidTransform& world_from_bone = world_from_bones[static_cast<std::size_t>(bone)];
  return transform_point(inverse(world_from_bones.front()) * world_from_bone, place.point_mm);
}

Vec3 BoneHistory::world_place_mm(const PlaceOnFragment& place, std::int64_t tick) const noexcept {
  std::int32_t fragment = place.fragment;
  const auto origin = [&] { return fragments[static_cast<std::size_t>(fragment)].origin; };
  while (origin().parent >= 0 && tick < origin().from_tick) fragment = origin().parent;
  return transform_point(world_from_fragment(fragment, tick), place.point_mm);
}

std::shared_ptr<const BoneHistory> build_history(HistoryRequest request, const Progress& progress) {
  auto history = std::make_shared<BoneHistory>();
  const Recording& recording = request.recording;
  const FragmentPoses lying = poses_of(request.bones);
  for (const Bone& bone : request.bones) history->world_from_bones.push_back(bone.world_from_bone);
  history->kerfs = growths_of(std::move(request.opened), recording);
  history->metal = metal_history(recording, request.tray, lying);
  history->hand = hand_history(recording);
  const std::vector<CutEvent> events = fragment_events(recording);
  FragmentPaths paths = fragment_paths(events, recording.samples, lying);
  std::vector<SpannedFragment> spanned =
      fragment_spans({request.bones, recording, history->kerfs, request.bridges, events},
                     part_of(progress, 0.0, spans_share));
  const auto count = static_cast<double>(spanned.size());
  for (std::size_t i = 0; i < spanned.size(); ++i) {
    const auto before = static_cast<double>(i) / count;
    FragmentHistory& fragment = history->fragments.emplace_back();
    fragment.origin = paths.origins[i];
    fragment.path = std::move(paths.paths[i]);
    build_stretches(fragment, std::move(spanned[i]), static_cast<std::int32_t>(i), history->kerfs,
                    history->metal.bores,
                    part_of(progress, spans_share + (1.0 - spans_share) * before,
                            spans_share + (1.0 - spans_share) * (before + 1.0 / count)));
  }
  if (history->fragments.size() == 1) history->fragments.front().whole.reset();
  report(progress, 1.0);
  return history;
}

}  // namespace hallux::simulator
