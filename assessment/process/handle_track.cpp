#include "assessment/process/handle_track.h"

#include <utility>

#include "assessment/process/place_track.h"
#include "simulator/base/units.h"

namespace hallux::assessment {

namespace {

/// In the memory of the places, which are needed no more.
HandleStretch with_speeds(PlaceStretch&& places) {
  const std::size_t count = places.count();
  std::vector<double>& speeds_mm_s = places.axes_mm[0];
  Vec3 before_mm = places.at_mm(0);
  for (std::size_t index = 0; index < count; ++index) {
    const std::size_t before = index == 0 ? 0 : index - 1;
    const std::size_t after = index + 1 == count ? index : index + 1;
    const Vec3 here_mm = places.at_mm(index);
    const double way_mm = length_of(places.at_mm(after) - before_mm);
    const double span_s = static_cast<double>(after - before) * step_s;
    speeds_mm_s[index] = after == before ? 0.0 : way_mm / span_s;
    before_mm = here_mm;
  }
  return {places.first_tick, std::move(speeds_mm_s), std::move(places.status)};
}

}  // namespace

std::vector<HandleStretch> handle_stretches(const simulator::Recorded& recorded,
                                            std::size_t together) {
  std::vector<PlaceStretch> places = followed_places(
      recorded,
      [](const simulator::TapeLine& line, const simulator::ToolSample&) {
        return std::optional(transform_from(line.device.world_from_handle).translation_mm);
      },
      together);
  std::vector<HandleStretch> stretches;
  stretches.reserve(places.size());
  for (PlaceStretch& each : places) stretches.push_back(with_speeds(std::exchange(each, {})));
  return stretches;
}

}  // namespace hallux::assessment
