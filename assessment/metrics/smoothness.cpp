#include "assessment/metrics/smoothness.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <complex>
#include <vector>

#include "simulator/base/units.h"

namespace hallux::assessment {

namespace {

constexpr double highest_hz = 10.0;
/// Of the spectrum at rest.
constexpr double least_share = 0.05;
/// By which the speeds are made longer with zeros, for a finer spectrum.
constexpr std::size_t padding = 4;

/// The size of the speeds' Fourier transform at one of `length` frequencies.
double size_at(std::span<const double> speeds, std::size_t frequency, std::size_t length) {
  const double turn_rad = -2.0 * pi * static_cast<double>(frequency) / static_cast<double>(length);
  std::complex<double> sum = 0.0;
  for (std::size_t i = 0; i < speeds.size(); ++i)
    sum += std::polar(speeds[i], turn_rad * static_cast<double>(i));
  return std::abs(sum);
}

/// From 0 to the last frequency that counts, as shares of the first.
std::vector<double> spectrum_of(std::span<const double> speeds, double rate_hz) {
  const std::size_t length = std::bit_ceil(padding * speeds.size());
  const double step_hz = rate_hz / static_cast<double>(length);
  const auto highest = static_cast<std::size_t>(std::floor(highest_hz / step_hz));
  const double at_rest = size_at(speeds, 0, length);
  std::vector<double> shares;
  std::size_t last = 0;
  for (std::size_t frequency = 0; frequency <= std::min(highest, length / 2); ++frequency) {
    shares.push_back(size_at(speeds, frequency, length) / at_rest);
    if (shares.back() >= least_share) last = frequency;
  }
  shares.resize(last + 1);
  return shares;
}

}  // namespace

double spectral_arc_length(std::span<const double> speeds_mm_s, double rate_hz) {
  const std::vector<double> shares = spectrum_of(speeds_mm_s, rate_hz);
  const double step = 1.0 / static_cast<double>(std::max<std::size_t>(shares.size() - 1, 1));
  double length = 0.0;
  for (std::size_t i = 1; i < shares.size(); ++i)
    length += std::hypot(step, shares[i] - shares[i - 1]);
  return -length;
}

double log_dimensionless_jerk(std::span<const double> speeds_mm_s, double rate_hz) {
  const double span_s = 1.0 / rate_hz;
  double integral = 0.0;
  for (std::size_t i = 1; i + 1 < speeds_mm_s.size(); ++i) {
    const double bent = speeds_mm_s[i + 1] - 2.0 * speeds_mm_s[i] + speeds_mm_s[i - 1];
    const double jerk = bent / (span_s * span_s);
    integral += jerk * jerk * span_s;
  }
  const double peak = *std::max_element(speeds_mm_s.begin(), speeds_mm_s.end());
  const double duration_s = static_cast<double>(speeds_mm_s.size() - 1) * span_s;
  return -std::log(duration_s * duration_s * duration_s / (peak * peak) * integral);
}

}  // namespace hallux::assessment
