/// The tremble of a running saw, for the device alone: open loop, added after everything that is
/// recorded or judged. Inside this room only.
///
/// A saw runs at 10,000 to 20,000 cycles a minute, 167 to 333 Hz: three to six samples a cycle at 1
/// kHz, which no device renders. So the hand gets half the true rate, within 90 to 150 Hz; sound
/// has the true one (ui/sound). It is part neither of the recorded force, nor of the step's output,
/// nor of any account of energy: it cannot hold a wall up and must not be taken for one.
/// source  docs/haptics.md, Vibration
#pragma once

#include <cstdint>

#include "simulator/base/random.h"
#include "simulator/contact/feed.h"

namespace hallux::simulator {

inline constexpr double vibration_low_hz = 90.0, vibration_high_hz = 150.0;
inline constexpr double vibration_share_of_rate = 0.5;
inline constexpr double vibration_free_newton = 0.1;
inline constexpr double vibration_full_newton = 0.5;
/// Where it is full: 10 N on 10 mm of cortical bone by the feed law, with a kerf of 0.5 mm.
inline constexpr double vibration_full_watt = 0.9;
/// Each cycle is so much stronger or weaker, at most.
inline constexpr double vibration_noise = 0.1;
/// Between free, cutting and off it comes and goes within this.
inline constexpr double vibration_settle_s = 0.02;

struct VibrationState {
  explicit VibrationState(std::uint64_t seed) noexcept : noise(seed, "vibration") {}

  /// Phase, [0, 1).
  double turns = 0.0;
  double amplitude_newton = 0.0;
  double cycle_strength = 1.0;
  Random noise;
};

struct VibrationInput {
  bool saw_runs = false;
  double cycles_per_minute = 12000.0;
  double cutting_watt = 0.0;
  double duration_s = 0.001;
};

/// What taking away bone costs at this feed [W].
double cutting_watt(const Engagement& engaged, double kerf_mm, double feed_mm_s) noexcept;

/// What the hand feels at this rate of the saw [Hz].
double vibration_hz(double cycles_per_minute) noexcept;

/// The force along the tooth line at the end of the tick [N]; at most 0.55 to both sides.
/// needs   duration_s > 0
/// errors  none: total, allocates nothing; the same seed and inputs give the same bits
/// thread  haptic
double vibrate(VibrationState& state, const VibrationInput& input) noexcept;

}  // namespace hallux::simulator
