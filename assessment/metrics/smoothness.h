/// How smooth one movement was, by its speed. Values nearer to 0 are smoother.
/// Inside this room only.
#pragma once

#include <span>

namespace hallux::assessment {

/// The spectral arc length: how long the line of the speed's spectrum is, up to 10 Hz or to the
/// last frequency at which a twentieth of the spectrum's beginning is left. More sub-movements make
/// it longer, so more negative; neither the size nor the duration of a movement changes it.
/// needs   at least two speeds, their sum above 0
/// ensures at most 0
/// source  docs/metrics.md, "Smoothness" (Balasubramanian 2015)
double spectral_arc_length(std::span<const double> speeds_mm_s, double rate_hz);

/// -ln(duration^3 / peak^2 x the integral of the squared second derivative of the speed).
/// needs   at least three speeds, one of them above 0; not all of their second differences 0
/// source  docs/metrics.md, "Smoothness" (Balasubramanian 2015)
double log_dimensionless_jerk(std::span<const double> speeds_mm_s, double rate_hz);

}  // namespace hallux::assessment
