/// How long frames took, in three numbers.
#pragma once

#include <optional>
#include <vector>

namespace hallux::ui {

struct FrameTimes {
  double median_ms = 0.0, p99_ms = 0.0, max_ms = 0.0;
};

/// By nearest rank: each is a time that a frame really took. Nothing where there were no frames.
std::optional<FrameTimes> frame_times(std::vector<double> frame_ms);

}  // namespace hallux::ui
