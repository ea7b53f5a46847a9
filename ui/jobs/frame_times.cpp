#include "ui/jobs/frame_times.h"

#include <algorithm>

namespace hallux::ui {

std::optional<FrameTimes> frame_times(std::vector<double> frame_ms) {
  if (frame_ms.empty()) return std::nullopt;
  std::sort(frame_ms.begin(), frame_ms.end());
  const auto percentile = [&](std::size_t percent) {
    return frame_ms[(frame_ms.size() * percent + 99) / 100 - 1];
  };
  return FrameTimes{percentile(50), percentile(99), frame_ms.back()};
}

}  // namespace hallux::ui
