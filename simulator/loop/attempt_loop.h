/// The loop of an attempt: the one place with a thread's pace and a clock. Calls the step, feeds
/// jobs and recorder.
#pragma once

#include <cstdint>
#include <vector>

#include "simulator/base/progress.h"
#include "simulator/device/haptic_device.h"
#include "simulator/device/scripted.h"
#include "simulator/loop/attempt_operator.h"
#include "simulator/loop/attempt_watch.h"
#include "simulator/loop/device_link.h"
#include "simulator/loop/jobs.h"
#include "simulator/mesh/bone.h"
#include "simulator/record/channels.h"
#include "simulator/step/simulation.h"

namespace hallux::simulator {

/// RealTime  one tick a millisecond by absolute deadlines; the producer never waits for the
///           recorder
/// Virtual   as fast as it goes; the producer waits for room, and a job is ready at the next tick
enum class Pacing { RealTime, Virtual };

struct AttemptSetup {
  SimulationSetup simulation;
  Pacing pacing = Pacing::Virtual;
  /// Of the scripted operator, ascending.
  std::vector<HandCommand> commands = {};
  /// The attempt ends after this tick, or after Finish.
  std::int64_t last_tick = 0;
  /// Of somebody who operates live; outlives the attempt.
  AttemptWatch* watch = nullptr;
  /// What an arm is made to feel; nothing else.
  ForceLaw force_law = ForceLaw::Simulated;
  /// Who answers to what comes out; outlives the attempt.
  AttemptOperator* attempt_operator = nullptr;
  /// By bone what jobs on a thread cut, where somebody has it already; outlives the attempt. Those
  /// that are not there are made.
  std::vector<const WholeBone*> wholes = {};
  /// Where jobs run; outlives the attempt. None: on a thread in RealTime, at once in Virtual.
  JobRunner* job_runner = nullptr;
};

enum class AttemptEnd { Finished, ReachedLastTick, Cancelled, RecorderFailed };

/// Times are wall-clock, over every tick; percentiles to half a percent.
struct LoopStatistics {
  AttemptEnd end = AttemptEnd::ReachedLastTick;
  /// Steps taken.
  std::int64_t lines = 0;
  /// Simulated milliseconds.
  std::int64_t ticks = 0;
  /// RealTime: ticks that came in one line with the next.
  std::int64_t missed_ticks = 0;
  /// RealTime: gaps beyond three ticks, a full ring or disk; in any pacing: a device that was gone
  /// for longer than 200 ticks.
  std::int64_t pauses = 0;
  /// RealTime: how long they took, waiting for a full disk left out.
  std::int64_t unsampled_us = 0;
  /// RealTime: see ClockWatch.
  std::int64_t clock_steps = 0;
  /// With a fault of the device while the attempt's clock ran.
  std::int64_t faulted_ticks = 0;
  /// Mouse and keys have taken over from it.
  bool has_changed_device = false;
  /// RealTime: of the fullest ring towards the recorder.
  double ring_share_max = 0.0;
  double step_p50_us = 0.0, step_p99_us = 0.0, step_max_us = 0.0;
  /// RealTime.
  double late_p50_us = 0.0, late_p99_us = 0.0, late_max_us = 0.0;
  /// The system ran the loop before all else; asked for where it is watched, or pushes a hand.
  bool has_priority = false;
  /// The system kept its memory in place; asked for likewise.
  bool has_locked_memory = false;
  /// Device newtons per simulated newton; 1 where nobody is pushed back.
  double force_scale = 1.0;
  /// Bits of ForceLimit that occurred.
  std::uint32_t force_limits = 0;
  /// What the arm was made to feel.
  ForceLaw force_law = ForceLaw::Simulated;
};

/// Runs the attempt on the calling thread until its end, and closes the channels.
/// ensures every line of the tape, every sample and every event was pushed; none is dropped
/// errors  what a job (std::bad_alloc) or `progress` threw, after the device was let go and
///         channels and watch were closed
LoopStatistics run_attempt(const AttemptSetup& setup, HapticDevice& device,
                           AttemptChannels& channels, const Progress& progress = {});

}  // namespace hallux::simulator
