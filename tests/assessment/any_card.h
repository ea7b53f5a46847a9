/// Rubrics, measurements and whole score cards for tests of points.
#pragma once

#include <string>

#include "assessment/ledger.h"

namespace hallux::assessment {

/// Full points at 0, none from 1 mm on, of the metric "<id>_mm" of the cut "cut".
scenarios::RubricItem item(const std::string& id, const std::string& group,
                           std::int64_t weight_milli);
scenarios::Gate gate(const std::string& metric, double limit, std::int64_t cap_milli);
Measurement measured(const std::string& metric, double value);

/// Weights, measurements and gates of every kind, with what cannot be measured among them.
/// needs   to be called in a property of RapidCheck, which draws the numbers
database::ScoreCard any_card();

}  // namespace hallux::assessment
