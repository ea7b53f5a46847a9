/// How a hand pushes: it leads the handle so that it feels the force it means to keep.
/// Inside this corner only.
///
///     handle's speed = what it sees of the feed + (wanted - felt) / brace
///                      within lean and release
///
/// The arm gives way at once, like a damper; what the hand wants it changes a reaction time after
/// it has noticed why. So bone that gives way lets the handle run on until the hand notices: the
/// plunge.
#pragma once

#include "scenarios/hands/hand_skill.h"
#include "simulator/base/random.h"

namespace hallux::scenarios {

/// needs   brace and lean above 0
double handle_speed_mm_s(const Push& push, double wanted_newton, double felt_newton,
                         double seen_feed_mm_s) noexcept;

/// The push that a hand gives where it means to keep one: uneven, and harder the longer it sees no
/// progress.
class WantedPush {
 public:
  WantedPush(const Push& push, Random random) noexcept : push_(push), random_(random) {}

  /// thread  haptic; allocates nothing
  double next_newton(double meant_newton, double seen_feed_mm_s, double span_s) noexcept;
  /// A stroke is begun, or the blade was drawn back.
  void calm_down() noexcept { impatience_newton_ = 0.0; }

 private:
  Push push_;
  Random random_;
  double until_renewed_s_ = 0.0;
  double uneven_share_ = 0.0;
  double impatience_newton_ = 0.0;
};

}  // namespace hallux::scenarios
