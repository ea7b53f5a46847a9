/// The jobs of a recorded attempt: which they were, and the state of which tick each of them saw.
#pragma once

#include <cstdint>
#include <vector>

#include "simulator/jobs/geometry_job.h"
#include "simulator/record/tape_lines.h"

namespace hallux::simulator {

struct RecordedJob {
  /// As the step asked for it; of Pieces the kerf is not known.
  JobRequest request;
  /// When its result entered the step.
  std::int64_t applied_tick = 0;
};

/// The jobs that the input tape applied, in the order in which they were asked for. The tape names
/// them by number and tick; the events of the tick that applied one say what it was.
/// bones   of the patient
/// needs   tape and events are in the order of their ticks
/// ensures nothing where the recording has no tape
/// errors  those of whoever keeps the tape
std::vector<RecordedJob> recorded_jobs(const Recorded& recorded, std::size_t bones);

}  // namespace hallux::simulator
