#include "simulator/contact/vibration.h"

#include <algorithm>
#include <cmath>

#include "simulator/base/elementary.h"
#include "simulator/base/units.h"
#include "simulator/contact/heat_law.h"

namespace hallux::simulator {

double cutting_watt(const Engagement& engaged, double kerf_mm, double feed_mm_s) noexcept {
  return (engaged.cortical_mm * cortical_work_joule_per_mm3 +
          engaged.cancellous_mm * cancellous_work_joule_per_mm3) *
         kerf_mm * std::max(0.0, feed_mm_s);
}

double vibration_hz(double cycles_per_minute) noexcept {
  return std::clamp(vibration_share_of_rate * cycles_per_minute / 60.0, vibration_low_hz,
                    vibration_high_hz);
}

double vibrate(VibrationState& state, const VibrationInput& input) noexcept {
  const double load = std::clamp(input.cutting_watt / vibration_full_watt, 0.0, 1.0);
  const double wanted_newton =
      input.saw_runs
          ? vibration_free_newton + load * (vibration_full_newton - vibration_free_newton)
          : 0.0;
  // Linear, so that it arrives, and a saw that was switched off is still.
  const double change_newton = vibration_full_newton * input.duration_s / vibration_settle_s;
  state.amplitude_newton +=
      std::clamp(wanted_newton - state.amplitude_newton, -change_newton, change_newton);
  state.turns += vibration_hz(input.cycles_per_minute) * input.duration_s;
  if (state.turns >= 1.0) {
    state.turns -= std::floor(state.turns);
    // At the start of a cycle the force is near zero: another strength makes no step.
    state.cycle_strength = state.noise.uniform(1.0 - vibration_noise, 1.0 + vibration_noise);
  }
  return state.amplitude_newton * state.cycle_strength * elementary::sin(2.0 * pi * state.turns);
}

}  // namespace hallux::simulator
