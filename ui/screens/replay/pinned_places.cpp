#include "ui/screens/replay/pinned_places.h"

#include <algorithm>
#include <cstddef>

namespace hallux::ui {

namespace {

/// Of a piece that is no fragment, the bone.
std::int32_t fragment_of(const simulator::BoneHistory& history, std::int32_t piece) {
  const auto found = std::find_if(
      history.fragments.begin(), history.fragments.end(),
      [piece](const simulator::FragmentHistory& each) { return each.origin.piece == piece; });
  return found == history.fragments.end()
             ? 0
             : static_cast<std::int32_t>(found - history.fragments.begin());
}

}  // namespace

const simulator::PlaceOnFragment& PinnedPlaces::of(const simulator::BoneHistory& history,
                                                   const database::BonePoint& place) {
  const auto known = std::find_if(known_.begin(), known_.end(),
                                  [&](const auto& each) { return each.first == place; });
  if (known != known_.end()) return known->second;
  const auto& point = place.point_in_bone_mm;
  known_.emplace_back(place, history.place_at_last({fragment_of(history, place.body),
                                                    Vec3(point[0], point[1], point[2])}));
  return known_.back().second;
}

database::BonePoint bone_point_of(const simulator::BoneHistory& history,
                                  const simulator::PlaceOnFragment& place) {
  const Vec3& point = place.point_mm;
  const std::int32_t piece =
      history.fragments[static_cast<std::size_t>(place.fragment)].origin.piece;
  return {std::max(0, piece), {point.x, point.y, point.z}};
}

}  // namespace hallux::ui
