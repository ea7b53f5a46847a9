#include "scenarios/metric_names.h"

#include <algorithm>
#include <array>

namespace hallux::scenarios {
namespace {

constexpr std::array<MetricName, 12> metrics{{
    {"angle_deg", "deg", MetricSubject::Cut},
    {"location_mm", "mm", MetricSubject::Cut},
    {"depth_mm", "mm", MetricSubject::Cut},
    {"step_mm", "mm", MetricSubject::Cut},
    {"flatness_mm", "mm", MetricSubject::CutOrHinge},
    {"past_landmark_mm", "mm", MetricSubject::Cut},
    {"notch_mm", "mm", MetricSubject::Cut},
    {"wedge_error_deg", "deg", MetricSubject::Hinge},
    {"wedge_sagittal_deg", "deg", MetricSubject::Hinge},
    {"hinge_mm", "mm", MetricSubject::Hinge},
    {"over_cut_mm", "mm", MetricSubject::Hinge},
    {"hinge_lost", "", MetricSubject::Hinge},
}};

}  // namespace

std::span<const MetricName> known_metrics() noexcept { return metrics; }

const MetricName* find_metric(std::string_view name) noexcept {
  const auto found = std::find_if(metrics.begin(), metrics.end(),
                                  [&](const MetricName& metric) { return metric.name == name; });
  return found == metrics.end() ? nullptr : &*found;
}

}  // namespace hallux::scenarios
