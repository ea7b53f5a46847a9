/// The rings through which an attempt leaves the haptic thread for the recorder.
#pragma once

#include <atomic>

#include "simulator/record/record.h"
#include "simulator/record/ring.h"

namespace hallux::simulator {

/// Tape, samples and events never drop: in virtual time the producer waits for room, in real time a
/// ring that is nearly full pauses the attempt (see simulator/loop).
struct AttemptChannels {
  /// Room for a minute at 1 kHz: a writer on a slow disk may stall for seconds.
  explicit AttemptChannels(std::size_t capacity = 65536)
      : tape(capacity), samples(capacity), events(capacity) {}

  Ring<TapeLine> tape;
  Ring<ToolSample> samples;
  Ring<CutEvent> events;
  /// Set by the producer after its last push.
  std::atomic<bool> closed{false};
  /// Set by the recorder when it cannot write any more; the loop pauses the attempt and says so.
  std::atomic<bool> recorder_failed{false};
  /// Set by the recorder while it waits for room on a full disk; in real time the loop pauses for
  /// as long.
  std::atomic<bool> storage_full{false};
  /// Set by whoever operates: the recorder waits for room no longer, and fails.
  std::atomic<bool> gives_up{false};
};

}  // namespace hallux::simulator
