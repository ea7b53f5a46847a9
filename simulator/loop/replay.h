/// Replay: runs the step again from the recorded input and compares every output bit for bit.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "simulator/record/record.h"
#include "simulator/step/simulation.h"

namespace hallux::simulator {

struct ReplayResult {
  bool is_identical = false;
  std::int64_t first_difference_tick = -1;  ///< -1 where identical
  std::string difference;                   ///< one sentence; empty where identical
  Digest outputs;                           ///< digest_outputs of what the replay gave
  Digest bone;                              ///< digest of the solid as it stood at the end
  std::int64_t samples = 0;
};

/// Called with the fraction done [0, 1]; returning false cancels.
using ReplayProgress = std::function<bool(double)>;

/// Stops at the first difference. A tape that the step could not have been given is a difference, never a crash.
/// needs   the recording was made by this engine version, of an attempt with that setup
ReplayResult replay(const Recording& recording, const SimulationSetup& setup,
                    const ReplayProgress& progress = {});

}  // namespace hallux::simulator
