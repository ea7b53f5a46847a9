/// What the calls of the step cost while a recorded operation is stepped through again.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "tests/benchmarks/fragments/driven_operation.h"

namespace hallux::benchmarks {

struct AttemptCost {
  /// Of each work, of each call [us].
  std::map<std::string, std::vector<double>> times_us;
  /// Of the step's calls in all works: memory taken and given back.
  std::uint64_t heap_calls = 0;
};

/// Steps through all of it, with a clock around each call in a measured work.
void step_through(const simulator::Bone& bone, const DrivenRecording& driven, AttemptCost& cost);

}  // namespace hallux::benchmarks
