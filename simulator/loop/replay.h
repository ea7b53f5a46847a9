/// Replay: runs the step again from the recorded input and compares every output bit for bit.
#pragma once

#include <cstdint>
#include <string>

#include "simulator/base/progress.h"
#include "simulator/jobs/geometry_job.h"
#include "simulator/record/record.h"
#include "simulator/step/simulation.h"

namespace hallux::simulator {

struct ReplayResult {
  bool is_identical = false;
  /// -1 where identical.
  std::int64_t first_difference_tick = -1;
  /// One sentence; empty where identical.
  std::string difference;
  /// digest_outputs of what the replay gave.
  Digest outputs;
  /// Digest of the solid as it stood at the end.
  Digest bone;
  std::int64_t samples = 0;
};

/// Stops at the first difference. A tape that the step could not have been given is a difference,
/// never a crash.
/// needs   the recording was made by this engine version, of an attempt with that setup
ReplayResult replay(const Recording& recording, const SimulationSetup& setup,
                    const Progress& progress = {});

}  // namespace hallux::simulator
