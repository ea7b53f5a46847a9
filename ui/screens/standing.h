/// How a trainee stands in an operation, as a shape: not started, learning, slipped, long ago.
///
/// No state says "competent": assessment/learning declares that from passed assessments, which these counts do not hold. A
/// shape says only what the stored results say.
#pragma once

#include <string_view>

#include "database/records/course.h"
#include "ui/widgets/theme.h"

namespace hallux::ui {

/// The last result lies so far below the best that noise of one attempt does not explain it (about the smallest
/// detectable change, 18.6 of 100 for a spread of 15 and a reliability of 0.8).
inline constexpr std::int64_t slipped_by_milli = 20'000;
inline constexpr int long_ago_days = 90;

Competence competence_of(const database::OperationStanding& standing, std::string_view now_utc);

/// The share of the ring that is filled while learning, 0-1: the best score of 100.
float progress_of(const database::OperationStanding& standing) noexcept;

}  // namespace hallux::ui
