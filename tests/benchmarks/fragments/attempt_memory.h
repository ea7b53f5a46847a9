/// Memory of a live attempt: step, jobs and picture, by the pages of this process.
#pragma once

#include "tests/benchmarks/fragments/driven_operation.h"

namespace hallux::benchmarks {

/// Megabytes, at most so far. Of the bone as it was (its tissues, its tree) nothing.
struct AttemptMemory {
  /// The three sets of kerfs alone: of step, jobs and picture.
  double kerfs = 0.0;
  /// All of it.
  double attempt = 0.0;
};

/// Steps through all of it.
AttemptMemory memory_of(const simulator::Bone& bone, const DrivenRecording& driven);

}  // namespace hallux::benchmarks
