/// From the least to the most of a size that is made. Inside this corner only.
#pragma once

namespace hallux::simulator {

struct SizeRange {
  double least = 0.0;
  double most = 0.0;

  /// Both ends belong to it; NaN does not.
  constexpr bool holds(double size) const noexcept { return size >= least && size <= most; }
};

}  // namespace hallux::simulator
