#include "simulator/base/time_spread.h"

#include <algorithm>
#include <bit>

namespace hallux {

namespace {

/// Classes for each doubling, as a power of two.
constexpr int doubling_bits = 8;
constexpr std::uint64_t per_doubling = std::uint64_t{1} << doubling_bits;
/// Eighteen minutes: longer times are counted with those.
constexpr int greatest_bits = 40;
constexpr std::size_t class_count =
    static_cast<std::size_t>(greatest_bits - doubling_bits + 1) * per_doubling;

/// How many bits of a time its class does not keep.
int dropped_bits(std::uint64_t time_ns) noexcept {
  return std::max(0, static_cast<int>(std::bit_width(time_ns)) - doubling_bits - 1);
}

/// Each doubling begins where the one before ends: its times, less dropped bits, are 256 to 511.
std::size_t class_of(std::uint64_t time_ns) noexcept {
  const int dropped = dropped_bits(time_ns);
  const std::uint64_t place =
      static_cast<std::uint64_t>(dropped) * per_doubling + (time_ns >> dropped);
  return std::min<std::size_t>(place, class_count - 1);
}

/// The middle of a class [ns].
double middle_of(std::size_t place) noexcept {
  const std::size_t doubling = place / per_doubling;
  const std::size_t dropped = doubling > 1 ? doubling - 1 : 0;
  const std::uint64_t width = std::uint64_t{1} << dropped;
  const std::uint64_t first = (place - dropped * per_doubling) << dropped;
  return static_cast<double>(first) + 0.5 * static_cast<double>(width - 1);
}

}  // namespace

TimeSpread::TimeSpread() : counts_(class_count) {}

void TimeSpread::add(std::chrono::nanoseconds time) noexcept {
  const auto time_ns = static_cast<std::uint64_t>(std::max<std::int64_t>(0, time.count()));
  ++counts_[class_of(time_ns)];
  ++count_;
  greatest_ns_ = std::max(greatest_ns_, time_ns);
}

double TimeSpread::at_us(double share) const noexcept {
  if (count_ == 0) return 0.0;
  const auto wanted = static_cast<std::uint64_t>(share * static_cast<double>(count_ - 1));
  std::uint64_t passed = 0;
  std::size_t place = 0;
  while (passed + counts_[place] <= wanted) passed += counts_[place++];
  return std::min(1.0e-3 * middle_of(place), greatest_us());
}

double TimeSpread::greatest_us() const noexcept {
  return 1.0e-3 * static_cast<double>(greatest_ns_);
}

}  // namespace hallux
