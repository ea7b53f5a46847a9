#include "scenarios/metric_names.h"

#include <algorithm>
#include <array>

namespace hallux::scenarios {
namespace {

constexpr std::array<MetricName, 10> metrics{{
    {"angle_deg", "deg", true},
    {"location_mm", "mm", true},
    {"depth_mm", "mm", true},
    {"step_mm", "mm", true},
    {"flatness_mm", "mm", true},
    {"past_landmark_mm", "mm", true},
    {"notch_mm", "mm", true},
    {"wedge_angle_deg", "deg", false},
    {"sagittal_wedge_deg", "deg", false},
    {"hinge_mm", "mm", false},
}};

}  // namespace

std::span<const MetricName> known_metrics() noexcept { return metrics; }

const MetricName* find_metric(std::string_view name) noexcept {
  const auto found = std::find_if(metrics.begin(), metrics.end(),
                                  [&](const MetricName& metric) { return metric.name == name; });
  return found == metrics.end() ? nullptr : &*found;
}

}  // namespace hallux::scenarios
