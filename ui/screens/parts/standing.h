/// How somebody stands in an operation, as a shape: the one rule of the cohort's grid, the
/// trainee's page, the choice of operations and the own history.
///
///     competent     enough assessments passed (assessment/learning.h)
///     slipped       was competent and failed too often since; or the last result lies far below
///                   the best
///     not started   never tried
///     long ago      not tried for 90 days
///     learning      all else; the ring fills with the evidence
#pragma once

#include <string_view>

#include "assessment/learning.h"
#include "database/records/course.h"
#include "ui/widgets/look/theme.h"

namespace hallux::ui {

/// The last result lies so far below the best that noise of one attempt does not explain it (about
/// the smallest detectable change, 18.6 of 100 for a spread of 15 and a reliability of 0.8).
inline constexpr std::int64_t slipped_by_milli = 20'000;
inline constexpr int long_ago_days = 90;

Competence competence_of(const database::OperationStanding& standing,
                         const assessment::LearningState& learning, std::string_view now_utc);

/// The share of the ring that is filled while learning, 0-1: the evidence that is needed; the best
/// score of 100 where no assessment counts yet.
float progress_of(const database::OperationStanding& standing,
                  const assessment::LearningState& learning) noexcept;

}  // namespace hallux::ui
