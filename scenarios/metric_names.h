/// The metrics that a rubric may name, with the unit each is said in.
#pragma once

#include <span>
#include <string_view>

namespace hallux::scenarios {

/// What an item or gate with this metric must name.
enum class MetricSubject {
  Cut,
  Hinge,      ///< the bridge, or the wedge that its two cuts take out
  CutOrHinge  ///< one cut, or the worse of a hinge's two
};

struct MetricName {
  std::string_view name, unit;
  MetricSubject subject = MetricSubject::Cut;
};

/// source  docs/metrics.md
std::span<const MetricName> known_metrics() noexcept;
/// Nothing (null) where there is no metric of that name; what is returned lives as long as the program.
const MetricName* find_metric(std::string_view name) noexcept;

}  // namespace hallux::scenarios
