/// The rings through which an attempt leaves the haptic thread, and what was on the screen the
/// window's, for the recorder.
#pragma once

#include <atomic>

#include "simulator/record/display_fact.h"
#include "simulator/record/record.h"
#include "simulator/record/ring.h"

namespace hallux::simulator {

/// Tape, samples and events never drop: in virtual time the producer waits for room, in real time a
/// ring that is nearly full pauses the attempt (see simulator/loop).
struct AttemptChannels {
  /// Half a minute of a view that turns all the time.
  static constexpr std::size_t display_fact_room = 256;

  /// Room for a minute at 1 kHz: a writer on a slow disk may stall for seconds.
  explicit AttemptChannels(std::size_t capacity = 65536)
      : tape(capacity), samples(capacity), events(capacity) {}

  Ring<TapeLine> tape;
  Ring<ToolSample> samples;
  Ring<CutEvent> events;
  /// Producer: the window. A full one drops, and the next fact counts what was lost.
  Ring<DisplayFact> display_facts{display_fact_room};
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
