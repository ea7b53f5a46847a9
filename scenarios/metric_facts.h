/// What each metric is computed by, and where that comes from, in one line each: for whoever reads
/// a score without the program. docs/metrics.md says it in full.
#pragma once

#include <string_view>

#include "scenarios/metric_names.h"

namespace hallux::scenarios {

struct MetricFacts {
  Metric metric = Metric::Count;
  std::string_view formula, source;
};

/// needs   metric is not Metric::Count
const MetricFacts& facts_of(Metric metric) noexcept;

}  // namespace hallux::scenarios
