/// The force law of the thesis that began this project (its section 6.5), kept for the lesson: what
/// a hand felt then. Inside this room only.
///
///     V = way of the handle since the frame before / t    t: a frame, 1/60 s
///     R = V - 2 (V . N) N                                 at a collision; the device is to leave
///                                                         with R: f = m (R - V) / t for one frame
///     U = m (V - V before) / t - f before                 what the hand pushes, inferred from the
///                                                         handle's acceleration
///     f += -(U . N) N                                     where it pushes into the surface
///
/// Two things are ours. The thesis prints R = V + 2 (V . N), which adds a number to a vector. And
/// it reflects all of U, which would push on along the surface; only the part into it is opposed
/// here. Why nothing else here uses it: it chatters and sinks in at 60 frames a second, and at 1000
/// an encoder's step is a newton (docs/haptics.md, Three laws at a plate).
#pragma once

#include <cstdint>
#include <optional>

#include "simulator/base/vector.h"

namespace hallux::simulator {

struct ThesisLawSettings {
  /// Of the device's handle.
  double mass_kg = 0.15;
  /// 1/60 s in whole ticks.
  std::int64_t frame_ticks = 17;
  double force_limit_newton = 8.0;
};

struct ThesisLawState {
  /// At the frame before.
  Vec3 handle_mm{0.0, 0.0, 0.0};
  Vec3 velocity_mm_s{0.0, 0.0, 0.0};
  /// Given since.
  Vec3 force_newton{0.0, 0.0, 0.0};
  /// Since the frame before.
  std::int64_t frame_ticks = 0;
  /// Seen since the beginning; counted to 2.
  std::int32_t frames = 0;
};

/// The force [N] on the hand; it changes once a frame. `normal` points out of the surface that the
/// tool touches, none in air.
/// needs   ticks > 0, the normal has length 1
/// errors  none: total, allocates nothing
Vec3 thesis_law_force(ThesisLawState& state, const ThesisLawSettings& settings,
                      const Vec3& handle_mm, const std::optional<Vec3>& normal,
                      std::int64_t ticks) noexcept;

}  // namespace hallux::simulator
