#include "assessment/process/pushes.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "assessment/metrics/face_plane.h"
#include "assessment/process/sample_spans.h"
#include "simulator/record/sample_force.h"

namespace hallux::assessment {

namespace {

using simulator::ToolSample;
using simulator::ToolStatus;

constexpr std::size_t window_ticks = 20;
constexpr double upper_share = 0.95;

/// The force at one tick in which teeth advanced.
struct Push {
  std::int64_t tick = 0;
  double size_newton = 0.0, aside_newton = 0.0;
};

/// Each sample for every tick that it covers.
std::vector<Push> pushes_of(std::span<const ToolSample> samples, std::size_t first,
                            std::size_t last) {
  std::vector<Push> pushes;
  for (std::size_t index = first; index <= last; ++index) {
    const ToolSample& sample = samples[index];
    const Vec3 normal = axis_z(transform_from(sample.world_from_tool));
    const double size_newton = simulator::force_size_newton(sample);
    const double aside_newton = glm::dot(simulator::force_newton(sample), normal);
    for (std::int64_t back = ticks_covered(samples, index); back-- > 0;)
      pushes.push_back({sample.tick - back, size_newton, aside_newton});
  }
  return pushes;
}

/// A tick sooner or later at either end: two pushes of the window are others, of those in and
/// around it.
double window_bound_newton(std::span<const Push> around) {
  double least_newton = INFINITY, greatest_newton = 0.0;
  for (const Push& push : around) {
    least_newton = std::min(least_newton, push.size_newton);
    greatest_newton = std::max(greatest_newton, push.size_newton);
  }
  return 2.0 * (greatest_newton - least_newton) / static_cast<double>(window_ticks);
}

/// The greatest mean over a window of ticks that follow each other.
void raise_peak(std::optional<Finding>& peak, std::span<const Push> stretch) {
  double sum_newton = 0.0;
  for (std::size_t i = 0; i < stretch.size(); ++i) {
    sum_newton += stretch[i].size_newton;
    if (i >= window_ticks) sum_newton -= stretch[i - window_ticks].size_newton;
    if (i + 1 < window_ticks) continue;
    const double mean_newton = sum_newton / static_cast<double>(window_ticks);
    if (peak && peak->value >= mean_newton) continue;
    const std::size_t first = i + 1 - window_ticks;
    const std::span<const Push> window = stretch.subspan(first, window_ticks);
    // With a tick before and after it, where there are any.
    const std::size_t begin = first > 0 ? first - 1 : 0;
    const std::span<const Push> around =
        stretch.subspan(begin, std::min(stretch.size(), i + 2) - begin);
    peak = Finding{mean_newton, window.front().tick, stretch[i].tick, window_bound_newton(around)};
  }
}

/// The percentile; `edges` pushes of all may be missing, or be there without having been.
Finding upper_of(std::vector<double> sizes_newton, std::int64_t edges) {
  std::sort(sizes_newton.begin(), sizes_newton.end());
  const double share = static_cast<double>(edges) / static_cast<double>(sizes_newton.size());
  const auto at = [&](double fraction) {
    return percentile(sizes_newton, std::clamp(fraction, 0.0, 1.0));
  };
  const double value = at(upper_share);
  return {value, 0, 0, std::max(at(upper_share + share) - value, value - at(upper_share - share))};
}

/// The root mean square of the force aside; the bound is of the greatest of them, as often.
Finding aside_of(std::span<const Push> pushes, std::int64_t edges) {
  double squares = 0.0, greatest = 0.0;
  for (const Push& push : pushes) {
    squares += push.aside_newton * push.aside_newton;
    greatest = std::max(greatest, push.aside_newton * push.aside_newton);
  }
  const double rms_newton = std::sqrt(squares / static_cast<double>(pushes.size()));
  if (!(rms_newton > 0.0)) return {};
  const double share = static_cast<double>(edges) / static_cast<double>(pushes.size());
  return {rms_newton, 0, 0, std::min(rms_newton, share * greatest / rms_newton)};
}

}  // namespace

Pushes measure_pushes(const simulator::Recording& recording) {
  const std::span<const ToolSample> samples = recording.samples;
  Pushes pushes;
  std::vector<Push> all;
  std::int64_t edges = 0;
  for_each_stretch(
      samples, [&](std::size_t index) { return has(samples[index].status, ToolStatus::Cutting); },
      [&](std::size_t first, std::size_t last) {
        const std::vector<Push> stretch = pushes_of(samples, first, last);
        raise_peak(pushes.peak_newton, stretch);
        all.insert(all.end(), stretch.begin(), stretch.end());
        edges += 2;
      });
  if (all.empty()) return pushes;
  std::vector<double> sizes_newton;
  sizes_newton.reserve(all.size());
  for (const Push& push : all) sizes_newton.push_back(push.size_newton);
  pushes.side_newton = aside_of(all, edges);
  pushes.p95_newton = upper_of(std::move(sizes_newton), edges);
  for (std::optional<Finding>* finding : {&pushes.side_newton, &pushes.p95_newton}) {
    (*finding)->first_tick = all.front().tick;
    (*finding)->last_tick = all.back().tick;
  }
  return pushes;
}

}  // namespace hallux::assessment
