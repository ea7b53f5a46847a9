/// Limit of assessments of an operation, and what is left of it.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>

namespace hallux::database {

/// Of one operation, for the trainees of a cohort. Practice is never limited.
struct AttemptLimit {
  std::string scenario_name;
  std::int32_t attempts_max = 0;
  /// Login; "" for erased people.
  std::string set_by;
  std::string set_utc;
};

/// What the strictest limit of a trainee's cohorts allows. Used are assessments begun since the
/// enrolment that are being recorded, closed and valid, or were interrupted after the blade had
/// touched bone; void ones are not.
struct AttemptAllowance {
  std::int32_t used = 0, attempts_max = 0;
  std::string cohort_name;

  std::int32_t left() const noexcept { return std::max(0, attempts_max - used); }
};

}  // namespace hallux::database
