/// What somebody who operates live has of the loop: commands in, the newest view and what the bone's picture follows out.
///
///     window    --commands--> haptic thread --view (the newest)--------------------> window
///                                          --feed (all of it, never dropped)-------> geometry thread
///
/// The feed carries kerf growth, so it is a ring like the recorder's: nearly full, it pauses the attempt.
#pragma once

#include <cstdint>
#include <variant>

#include "simulator/contact/feed.h"
#include "simulator/contact/heat_law.h"
#include "simulator/jobs/geometry_job.h"
#include "simulator/record/latest.h"
#include "simulator/record/record.h"
#include "simulator/record/ring.h"

namespace hallux::simulator {

/// The loop as it stood after its newest line.
struct LoopView {
  ToolSample sample;
  Engagement engaged;
  double hottest_celsius = body_celsius;  ///< of all bone, by the model
  std::int64_t lines = 0;                 ///< steps taken; 0: none yet
  std::int64_t missed_ticks = 0;          ///< that came in one line with the next
  std::int64_t pauses = 0;  ///< by the loop: gaps beyond three ticks, a full ring or disk
  double late_us = 0.0;     ///< the most of the last whole second
  double ring_share = 0.0;  ///< of the fullest ring towards recorder and geometry
  Vec3 device_force_newton{0.0, 0.0, 0.0};  ///< that the device is given next, in the world
  std::uint32_t force_limits = 0;  ///< bits of ForceLimit: what made it another than simulated
  bool has_priority = false;       ///< the system runs the loop before all else
  bool has_locked_memory = false;  ///< the system keeps its memory in place
  bool is_storage_full = false;    ///< it pauses until the recorder has room on the disk
  bool is_over = false;
};

using GeometryFeed = std::variant<ToolSample, CutEvent, JobRequest>;

struct AttemptWatch {
  /// Room for half a minute: the geometry thread may be busy with a commit for seconds.
  explicit AttemptWatch(std::size_t feed_capacity = 32768) : commands(64), feed(feed_capacity) {}

  Ring<Command> commands;  ///< producer: window; taken at the next line, in order
  Ring<GeometryFeed>
      feed;  ///< producer: haptic; of a tick first its events, then its sample, then its requests
  Latest<LoopView> view;
  std::atomic<bool> closed{false};  ///< set by the loop after its last push to the feed
};

}  // namespace hallux::simulator
