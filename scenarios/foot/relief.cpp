#include "scenarios/foot/relief.h"

#include <array>
#include <cstdint>

namespace hallux::scenarios {
namespace {

/// A number in [-1, 1) that belongs to a lattice node; the mixer of SplitMix64.
double node_value(std::int64_t i, std::int64_t j, std::int64_t k, std::uint64_t octave) {
  std::uint64_t bits = static_cast<std::uint64_t>(i) * 0x9e3779b97f4a7c15U +
                       static_cast<std::uint64_t>(j) * 0xc2b2ae3d27d4eb4fU +
                       static_cast<std::uint64_t>(k) * 0x165667b19e3779f9U + octave;
  bits = (bits ^ (bits >> 30U)) * 0xbf58476d1ce4e5b9U;
  bits = (bits ^ (bits >> 27U)) * 0x94d049bb133111ebU;
  bits ^= bits >> 31U;
  return static_cast<double>(bits >> 11U) * 0x1.0p-52 - 1.0;
}

/// Quintic fade between two nodes along one axis.
Dual fade(double t, const Vec3& slope) {
  return {t * t * t * (t * (t * 6.0 - 15.0) + 10.0),
          slope * (30.0 * t * t * (t * (t - 2.0) + 1.0))};
}

Dual mix(const Dual& from, const Dual& to, const Dual& share) { return from + (to - from) * share; }

Dual octave_at(const Vec3& point_mm, double wavelength_mm, std::uint64_t octave) {
  const double frequency = 1.0 / wavelength_mm;
  const Vec3 scaled = point_mm * frequency;
  const Vec3 floor{std::floor(scaled.x), std::floor(scaled.y), std::floor(scaled.z)};
  const auto i = static_cast<std::int64_t>(floor.x);
  const auto j = static_cast<std::int64_t>(floor.y);
  const auto k = static_cast<std::int64_t>(floor.z);
  const Dual x = fade(scaled.x - floor.x, {frequency, 0.0, 0.0});
  const Dual y = fade(scaled.y - floor.y, {0.0, frequency, 0.0});
  const Dual z = fade(scaled.z - floor.z, {0.0, 0.0, frequency});
  std::array<Dual, 4> edges;
  for (std::int64_t e = 0; e < 4; ++e) {
    const std::int64_t dj = e % 2;
    const std::int64_t dk = e / 2;
    edges[static_cast<std::size_t>(e)] = mix({node_value(i, j + dj, k + dk, octave)},
                                             {node_value(i + 1, j + dj, k + dk, octave)}, x);
  }
  return mix(mix(edges[0], edges[1], y), mix(edges[2], edges[3], y), z);
}

}  // namespace

Dual relief_at(const Vec3& point_mm) noexcept {
  return octave_at(point_mm, 4.2, 1) * 0.8 + octave_at(point_mm, 1.6, 2) * 0.4;
}

}  // namespace hallux::scenarios
