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
  const Vec3 point_mm(point[0], point[1], point[2]);
  known_.emplace_back(
      place, place.body == 0 ? history.place_at_last(point_mm)
                             : history.place_at_last({fragment_of(history, place.body), point_mm}));
  return known_.back().second;
}

database::BonePoint bone_point_of(const simulator::BoneHistory& history,
                                  const simulator::PlaceOnFragment& place) {
  const std::int32_t piece =
      history.fragments[static_cast<std::size_t>(place.fragment)].origin.piece;
  const Vec3 point = piece > 0 ? place.point_mm : history.point_in_first_mm(place);
  return {std::max(0, piece), {point.x, point.y, point.z}};
}

}  // namespace hallux::ui
