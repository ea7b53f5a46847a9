/// Whole attempts through the loop, kept in memory: for tests of the loop and of replay.
#pragma once

#include <cstdint>

#include "simulator/base/progress.h"
#include "simulator/loop/attempt_loop.h"
#include "simulator/record/channels.h"
#include "simulator/record/record.h"

namespace hallux::tests {

/// A block 20 x 2.4 x 6 of soft bone, turned and far from the origin.
simulator::Bone loop_block();

/// The hand saws once through loop_block() and lifts the blade, in `last_tick` ticks from Start to
/// Finish.
simulator::HandMotion sawing_motion(const simulator::Bone& bone, std::int64_t last_tick);

/// That motion in virtual time, with its own commands; borrows the bone.
simulator::AttemptSetup setup_for(const simulator::Bone& bone, const simulator::HandMotion& motion,
                                  std::int64_t last_tick);

struct RecordedRun {
  simulator::LoopStatistics statistics;
  simulator::Recording recording;
};

/// Runs the attempt; a thread of its own empties the rings, as the recorder does.
RecordedRun record(const simulator::AttemptSetup& setup, simulator::HapticDevice& device,
                   std::size_t ring_capacity = 4096, const Progress& progress = {});

/// The same through channels of the caller, who may set their flags meanwhile.
RecordedRun record(const simulator::AttemptSetup& setup, simulator::HapticDevice& device,
                   simulator::AttemptChannels& channels, const Progress& progress = {});

/// The digest of every column of the input tape.
Digest digest_of_tape(const simulator::Recording& recording) noexcept;

}  // namespace hallux::tests
