#include "scenarios/hands/held_axis.h"

#include <algorithm>

#include "simulator/base/elementary.h"
#include "simulator/base/units.h"

namespace hallux::scenarios {

namespace {

/// How fast a hand whose blade is held by bone lets itself go, and how fast it takes care again
/// [1/s].
constexpr double carelessness_per_s = 0.4, care_per_s = 2.0;
/// With its eyes on the blade it wanders by this share, and comes to what it means in such a time.
constexpr double careful_share = 0.05, bring_s = 0.1;

}  // namespace

Wander::Wander(Random random) noexcept {
  for (Wave& wave : waves_) {
    wave.rate_rad_s = 2.0 * pi * random.uniform(0.05, 0.4);
    wave.phase_rad = 2.0 * pi * random.uniform();
  }
}

double Wander::at(double time_s) const noexcept {
  double sum = 0.0;
  for (const Wave& wave : waves_) {
    sum += elementary::sin(wave.rate_rad_s * time_s + wave.phase_rad);
  }
  return sum / 3.0;
}

void HeldAxis::hold(double time_s, double span_s, double noticed) noexcept {
  wave_ = wander_.at(time_s);
  share_ = std::min(1.0, share_ + carelessness_per_s * span_s);
  correction_ -= steadying_per_s_ * span_s * (noticed - meant_);
}

void HeldAxis::bring(double time_s, double span_s) noexcept {
  wave_ = wander_.at(time_s);
  share_ = std::max(careful_share, share_ - care_per_s * span_s);
  correction_ += (meant_ - correction_) * std::min(1.0, span_s / bring_s);
}

void HeldAxis::put(double value) noexcept {
  correction_ = value - share_ * size_ * wave_;
  meant_ = 0.0;
}

}  // namespace hallux::scenarios
