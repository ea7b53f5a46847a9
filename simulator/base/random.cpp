#include "simulator/base/random.h"

#include <cmath>

#include "simulator/base/elementary.h"
#include "simulator/base/units.h"

namespace hallux {

namespace {

/// FNV-1a, 64 bit: only to turn a name into a seed.
std::uint64_t hash_name(std::string_view name) noexcept {
  std::uint64_t hash = 14695981039346656037ULL;
  for (const char letter : name) {
    hash ^= static_cast<unsigned char>(letter);
    hash *= 1099511628211ULL;
  }
  return hash;
}

}  // namespace

Random::Random(std::uint64_t seed, std::string_view name) noexcept : state_(seed) {
  state_ = bits() ^ hash_name(name);
}

std::uint64_t Random::bits() noexcept {
  state_ += 0x9E3779B97F4A7C15ULL;
  std::uint64_t z = state_;
  z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9ULL;
  z = (z ^ (z >> 27U)) * 0x94D049BB133111EBULL;
  return z ^ (z >> 31U);
}

double Random::uniform() noexcept { return static_cast<double>(bits() >> 11U) * 0x1.0p-53; }

double Random::uniform(double low, double high) noexcept { return low + (high - low) * uniform(); }

double Random::normal() noexcept {
  const double radius = std::sqrt(-2.0 * elementary::log(1.0 - uniform()));
  return radius * elementary::cos(2.0 * pi * uniform());
}

double Random::truncated_normal(double mean, double deviation, double limit) noexcept {
  double value = normal();
  while (!(value >= -limit && value <= limit)) value = normal();
  return mean + deviation * value;
}

}  // namespace hallux
