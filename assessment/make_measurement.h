/// Measurements with their values rounded and their moments as times. Inside this corner only.
#pragma once

#include <cstdint>
#include <optional>

#include "assessment/measurement.h"
#include "assessment/process/finding.h"
#include "scenarios/metric_names.h"

namespace hallux::assessment {

/// A span of ticks, both ends included.
struct Moment {
  std::int64_t first_tick = 0, last_tick = 0;
};

/// ensures the value is rounded to 1e-6 of its unit, and nothing else rounds it; that is its bound,
///         beside the finding's; claims and counts are exact
Measurement measured(scenarios::Metric metric, double value, const Moment& moment,
                     const Vec3& place_in_bone_mm);
Measurement measured(scenarios::Metric metric, const Finding& finding,
                     const Vec3& place_in_bone_mm);

/// Without a value.
/// needs   why is not Absence::None
Measurement absent(scenarios::Metric metric, Absence why, const Vec3& place_in_bone_mm);

}  // namespace hallux::assessment
