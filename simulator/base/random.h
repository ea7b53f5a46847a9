/// Random numbers that are the same everywhere: a generator passed in with its seed, and named
/// sub-streams.
#pragma once

#include <cstdint>
#include <string_view>

namespace hallux {

/// SplitMix64 (Steele, Lea, Flood 2014): small, copyable, good enough for hands and patients; not
/// for secrets.
class Random {
 public:
  explicit Random(std::uint64_t seed) noexcept : state_(seed) {}
  /// The stream of one named quantity: adding a name never changes the numbers of another.
  Random(std::uint64_t seed, std::string_view name) noexcept;

  std::uint64_t bits() noexcept;
  /// [0, 1).
  double uniform() noexcept;
  /// [low, high).
  double uniform(double low, double high) noexcept;
  /// Mean 0, standard deviation 1 (Box-Muller).
  double normal() noexcept;
  /// A normal number drawn again until it lies within `limit` standard deviations.
  double truncated_normal(double mean, double deviation, double limit = 2.5) noexcept;

 private:
  std::uint64_t state_;
};

}  // namespace hallux
