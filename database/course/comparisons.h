/// Comparisons with a cohort, told to its trainees: snapshots from which nobody can be made out.
/// Inside this room only.
///
///     results now [ 61  70  72 ... ]   differ for 5 people or more   snapshot [ 58  70  72 ... ]
///     of 10 or more people  - - - - - - - - - - - - - - - - - - - - -> counted, median, quartiles
///
/// Only a snapshot is ever shown. The next one replaces it where five people's results changed,
/// came or went, so that whoever knows two of them, and their own result, learns nothing of one
/// other person. People who were erased stay in it.
#pragma once

#include <string>
#include <vector>

#include "database/records/comparison.h"
#include "database/store/connection.h"

namespace hallux::database {

/// By device class; those of which there are enough people. Makes the snapshots that are due.
std::vector<CohortComparison> cohort_comparisons(Database& database, CohortId cohort,
                                                 const std::string& scenario_name);

/// The value at `part` of the sorted values, between two of them on the line that joins them.
/// needs   values are sorted, and not empty; 0 <= part <= 1
double quantile(const std::vector<double>& values, double part) noexcept;

}  // namespace hallux::database
