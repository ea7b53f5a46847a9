#include "assessment/process/pushes.h"

#include <cmath>
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

bool is_cutting(const ToolSample& sample) noexcept {
  return has(sample.status, ToolStatus::Cutting);
}

/// The greatest mean over a window within this stretch of ticks that follow each other.
void raise_peak(std::optional<Finding>& peak, std::span<const ToolSample> stretch) {
  double sum_newton = 0.0;
  for (std::size_t i = 0; i < stretch.size(); ++i) {
    sum_newton += simulator::force_size_newton(stretch[i]);
    if (i >= window_ticks) sum_newton -= simulator::force_size_newton(stretch[i - window_ticks]);
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
  for_each_stretch(
      samples, [&](std::size_t index) { return is_cutting(samples[index]); },
      [&](std::size_t first, std::size_t last) {
        raise_peak(pushes.peak_newton, samples.subspan(first, last - first + 1));
      });
  std::vector<double> sizes_newton;
  double squares = 0.0;
  std::int64_t first_tick = 0, last_tick = 0;
  for (const ToolSample& sample : samples) {
    if (!is_cutting(sample)) continue;
    if (sizes_newton.empty()) first_tick = sample.tick;
    last_tick = sample.tick;
    sizes_newton.push_back(simulator::force_size_newton(sample));
    const Vec3 normal = axis_z(transform_from(sample.world_from_tool));
    const double aside_newton = glm::dot(simulator::force_newton(sample), normal);
    squares += aside_newton * aside_newton;
  }
  if (sizes_newton.empty()) return pushes;
  const double count = static_cast<double>(sizes_newton.size());
  pushes.side_newton = Finding{std::sqrt(squares / count), first_tick, last_tick};
  pushes.p95_newton =
      Finding{percentile(std::move(sizes_newton), upper_share), first_tick, last_tick};
  return pushes;
}

}  // namespace hallux::assessment
