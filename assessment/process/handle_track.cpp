#include "assessment/process/handle_track.h"

#include <utility>

#include "assessment/process/place_track.h"
#include "simulator/base/units.h"

namespace hallux::assessment {

namespace {

HandleStretch with_speeds(PlaceStretch&& places) {
  HandleStretch stretch;
  stretch.first_tick = places.first_tick;
  const std::size_t count = places.count();
  stretch.speed_mm_s.reserve(count);
  for (std::size_t index = 0; index < count; ++index) {
    const std::size_t before = index == 0 ? 0 : index - 1;
    const std::size_t after = index + 1 == count ? index : index + 1;
    const double way_mm = length_of(places.at_mm(after) - places.at_mm(before));
    const double span_s = static_cast<double>(after - before) * step_s;
    stretch.speed_mm_s.push_back(after == before ? 0.0 : way_mm / span_s);
  }
  stretch.status = std::move(places.status);
  return stretch;
}

}  // namespace

std::vector<HandleStretch> handle_stretches(const simulator::Recording& recording,
                                            std::size_t together) {
  std::vector<PlaceStretch> places = followed_places(
      recording,
      [](const simulator::TapeLine& line, const simulator::ToolSample&) {
        return std::optional(transform_from(line.device.world_from_handle).translation_mm);
      },
      together);
  std::vector<HandleStretch> stretches;
  stretches.reserve(places.size());
  for (PlaceStretch& each : places) stretches.push_back(with_speeds(std::move(each)));
  return stretches;
}

}  // namespace hallux::assessment
