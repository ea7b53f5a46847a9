/// The metrics that a rubric may name, with the unit each is said in.
#pragma once

#include <span>
#include <string_view>

namespace hallux::scenarios {

struct MetricName {
  std::string_view name, unit;
  bool is_of_a_cut = true;  ///< false: of the operation as a whole, so an item names no cut
};

/// source  docs/metrics.md
std::span<const MetricName> known_metrics() noexcept;
/// Nothing (null) where there is no metric of that name; what is returned lives as long as the program.
const MetricName* find_metric(std::string_view name) noexcept;

}  // namespace hallux::scenarios
