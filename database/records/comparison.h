/// Comparison with a cohort in an operation, from which nobody can be made out.
/// Inside this room only.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "database/records/ids.h"

namespace hallux::database {

/// Fewer people than these are not compared with, and have no quartiles.
/// source  reference/domain.md 5.2 (10 for a position, 20 for percentiles), 5.9 (never fewer than
///         5)
inline constexpr std::int32_t compared_people_min = 10, quartile_people_min = 20;
/// So many people's results must differ before figures are made anew: two of them tell nothing of
/// one person.
inline constexpr std::int32_t changed_people_min = 5;

/// Each person by their newest result that is a grade, of one device class. Rounded to whole
/// points.
struct CohortComparison {
  CohortId cohort;
  std::string cohort_name, scenario_name, device_class;
  std::int32_t people = 0;
  std::int64_t median_milli = 0;
  /// Quartiles; nothing for too few people.
  std::optional<std::int64_t> lower_milli, upper_milli;
  /// Of that moment; results since then are not in it.
  std::string made_utc;
};

}  // namespace hallux::database
