/// Why a metric matters, and what to do next time, in a sentence each: what follows on a number in
/// the messages to who operated.
#pragma once

#include <string>
#include <string_view>

#include "scenarios/metric_names.h"

namespace hallux::scenarios {

struct MetricAdvice {
  Metric metric = Metric::Count;
  std::string_view why, next_time;
};

/// Both sentences of a metric; empty where there is none of that name. Unchecked by a surgeon, as
/// the origins of the knots are.
std::string advice_text(std::string_view metric);

}  // namespace hallux::scenarios
