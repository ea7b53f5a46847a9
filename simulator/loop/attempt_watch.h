/// What somebody who operates live has of the loop: commands in, the newest view and what the
/// bone's picture follows out.
///
///     window    --commands--> haptic thread --view (the newest)----------------> window
///                                           --feed (all of it, never dropped)--> geometry thread
///
/// The feed carries kerf growth, so it is a ring like the recorder's: nearly full, it pauses the
/// attempt.
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
  /// Of all bone, by the model.
  double hottest_celsius = body_celsius;
  /// Steps taken; 0: none yet.
  std::int64_t lines = 0;
  /// That came in one line with the next.
  std::int64_t missed_ticks = 0;
  /// By the loop: gaps beyond three ticks, a full ring or disk.
  std::int64_t pauses = 0;
  /// The most of the last whole second.
  double late_us = 0.0;
  /// Of the fullest ring towards recorder and geometry.
  double ring_share = 0.0;
  /// That the device is given next, in the world.
  Vec3 device_force_newton{0.0, 0.0, 0.0};
  /// Bits of ForceLimit: what made it another than simulated.
  std::uint32_t force_limits = 0;
  /// For so long that the loop pauses until it is there again.
  bool is_device_lost = false;
  /// The system runs the loop before all else.
  bool has_priority = false;
  /// The system keeps its memory in place.
  bool has_locked_memory = false;
  /// It pauses until the recorder has room on the disk.
  bool is_storage_full = false;
  bool is_over = false;
};

using GeometryFeed = std::variant<ToolSample, CutEvent, JobRequest>;

struct AttemptWatch {
  /// Room for half a minute: the geometry thread may be busy with a commit for seconds.
  explicit AttemptWatch(std::size_t feed_capacity = 32768) : commands(64), feed(feed_capacity) {}

  /// Producer: window; taken at the next line, in order.
  Ring<Command> commands;
  /// Producer: haptic; of a tick first its events, then its sample, then its requests.
  Ring<GeometryFeed> feed;
  Latest<LoopView> view;
  /// Set by the loop after its last push to the feed.
  std::atomic<bool> closed{false};
};

}  // namespace hallux::simulator
