#include "assessment/process/free_movements.h"

#include <algorithm>
#include <cmath>
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
  return !has(status, ToolStatus::InContact) && !has(status, ToolStatus::InKerf) &&
         !has(status, ToolStatus::InBore);
}

/// One value of each free movement.
using Values = std::vector<Finding>;

double median_of(const Values& movements, double fraction = 0.5) {
  std::vector<double> values;
  values.reserve(movements.size());
  for (const Finding& movement : movements) values.push_back(movement.value);
  return percentile(std::move(values), fraction);
}

/// Of a median over which so many values more or fewer are laid.
double neighbours_bound(const Values& movements, double more) {
  const double share = std::min(0.5, 0.5 * more / static_cast<double>(movements.size() - 1));
  const double median = median_of(movements);
  return std::max(median - median_of(movements, 0.5 - share),
                  median_of(movements, 0.5 + share) - median);
}

/// By what twice the step makes of the movements: a median moves by no more than the value that
/// moves most, and where a movement is just long enough, or just not, to its neighbour.
double bound_of(const Values& movements, const Values& coarse) {
  double ends = 0.0, steps = 0.0;
  for (const Finding& movement : movements) ends = std::max(ends, movement.bound);
  if (coarse.empty()) return ends;
  const double more =
      std::abs(static_cast<double>(movements.size()) - static_cast<double>(coarse.size()));
  if (more > 0.0) {
    steps = std::abs(median_of(movements) - median_of(coarse));
  } else {
    for (std::size_t index = 0; index < movements.size(); ++index)
      steps = std::max(steps, std::abs(movements[index].value - coarse[index].value));
  }
  return ends + steps + neighbours_bound(movements, std::max(1.0, more));
}

std::optional<Finding> smoothness_of(const Values& movements, const Values& coarse) {
  if (movements.size() < least_movements) return std::nullopt;
  const Finding& roughest =
      *std::min_element(movements.begin(), movements.end(),
                        [](const Finding& a, const Finding& b) { return a.value < b.value; });
  return Finding{median_of(movements), roughest.first_tick, roughest.last_tick,
                 bound_of(movements, coarse)};
}

}  // namespace

FreeMovements free_movements(std::span<const HandleStretch> stretches) {
  FreeMovements found;
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
          const auto shorter = speeds.subspan(1, count - 2);
          const std::int64_t first_tick = stretch.tick_at(first), last_tick = stretch.tick_at(last);
          const auto add = [&](Values& values, auto&& measure) {
            const double value = measure(speeds, rate_hz);
            const double bound = std::abs(value - measure(shorter, rate_hz));
            // A speed that never bends, as no hand's is, has no jerk to tell of.
            if (std::isfinite(value) && std::isfinite(bound))
              values.push_back({value, first_tick, last_tick, bound});
          };
          add(found.arcs, spectral_arc_length);
          add(found.jerks, log_dimensionless_jerk);
        });
  }
  return found;
}

Smoothness measure_smoothness(const FreeMovements& movements, const FreeMovements& coarse) {
  return {smoothness_of(movements.arcs, coarse.arcs), smoothness_of(movements.jerks, coarse.jerks)};
}

}  // namespace hallux::assessment
