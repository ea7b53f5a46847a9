#include "assessment/process/free_movements.h"

#include <algorithm>
#include <vector>

#include "assessment/metrics/face_plane.h"
#include "assessment/metrics/smoothness.h"
#include "simulator/base/units.h"

namespace hallux::assessment {

namespace {

using simulator::ToolStatus;

constexpr double least_speed_mm_s = 5.0;
constexpr std::size_t least_ticks = 300, least_movements = 3;
constexpr double rate_hz = 1.0 / step_s;

bool is_free(std::uint32_t status) noexcept {
  return !has(status, ToolStatus::InContact) && !has(status, ToolStatus::InKerf);
}

std::optional<Finding> median_of(const std::vector<Finding>& movements) {
  if (movements.size() < least_movements) return std::nullopt;
  std::vector<double> values;
  values.reserve(movements.size());
  for (const Finding& movement : movements) values.push_back(movement.value);
  const Finding& roughest =
      *std::min_element(movements.begin(), movements.end(),
                        [](const Finding& a, const Finding& b) { return a.value < b.value; });
  return Finding{percentile(std::move(values), 0.5), roughest.first_tick, roughest.last_tick};
}

}  // namespace

Smoothness measure_smoothness(std::span<const HandleStretch> stretches) {
  std::vector<Finding> arcs, jerks;
  for (const HandleStretch& stretch : stretches) {
    for_each_run(
        stretch,
        [&](std::size_t index) {
          return is_free(stretch.status[index]) && stretch.speed_mm_s[index] >= least_speed_mm_s;
        },
        [&](std::size_t first, std::size_t last) {
          const std::size_t count = last - first + 1;
          if (count < least_ticks) return;
          const auto speeds = std::span(stretch.speed_mm_s).subspan(first, count);
          const std::int64_t first_tick = stretch.tick_at(first), last_tick = stretch.tick_at(last);
          arcs.push_back({spectral_arc_length(speeds, rate_hz), first_tick, last_tick});
          jerks.push_back({log_dimensionless_jerk(speeds, rate_hz), first_tick, last_tick});
        });
  }
  return {median_of(arcs), median_of(jerks)};
}

}  // namespace hallux::assessment
