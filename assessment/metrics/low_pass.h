/// A low pass that moves nothing in time. Inside this room only.
#pragma once

#include <span>

namespace hallux::assessment {

struct LowPass {
  double cutoff_hz = 10.0;
  double rate_hz = 1000.0;
};

/// Takes the values, in place, through a Butterworth filter of second order, forward and then
/// backward: together of fourth order and without delay. Both ends are continued by the values
/// turned about them, over one period of the cut-off or as far as there are values, and each way
/// begins at rest there.
/// needs   0 < cutoff_hz < rate_hz / 2
/// source  docs/metrics.md, "Smoothness"
void low_pass(std::span<double> values, const LowPass& filter);

}  // namespace hallux::assessment
