#include "assessment/process/pushes.h"

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

/// The greatest mean over a window of ticks that follow each other.
void raise_peak(std::optional<Finding>& peak, std::span<const Push> stretch) {
  double sum_newton = 0.0;
  for (std::size_t i = 0; i < stretch.size(); ++i) {
    sum_newton += stretch[i].size_newton;
    if (i >= window_ticks) sum_newton -= stretch[i - window_ticks].size_newton;
    if (i + 1 < window_ticks) continue;
    const double mean_newton = sum_newton / static_cast<double>(window_ticks);
    if (peak && peak->value >= mean_newton) continue;
    peak = Finding{mean_newton, stretch[i + 1 - window_ticks].tick, stretch[i].tick};
  }
}

}  // namespace

Pushes measure_pushes(const simulator::Recording& recording) {
  const std::span<const ToolSample> samples = recording.samples;
  Pushes pushes;
  std::vector<Push> all;
  for_each_stretch(
      samples, [&](std::size_t index) { return has(samples[index].status, ToolStatus::Cutting); },
      [&](std::size_t first, std::size_t last) {
        const std::vector<Push> stretch = pushes_of(samples, first, last);
        raise_peak(pushes.peak_newton, stretch);
        all.insert(all.end(), stretch.begin(), stretch.end());
      });
  if (all.empty()) return pushes;
  std::vector<double> sizes_newton;
  double squares = 0.0;
  for (const Push& push : all) {
    sizes_newton.push_back(push.size_newton);
    squares += push.aside_newton * push.aside_newton;
  }
  const std::int64_t first_tick = all.front().tick, last_tick = all.back().tick;
  const double count = static_cast<double>(all.size());
  pushes.side_newton = Finding{std::sqrt(squares / count), first_tick, last_tick};
  pushes.p95_newton =
      Finding{percentile(std::move(sizes_newton), upper_share), first_tick, last_tick};
  return pushes;
}

}  // namespace hallux::assessment
