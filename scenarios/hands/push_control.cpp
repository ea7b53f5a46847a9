#include "scenarios/hands/push_control.h"

#include <algorithm>

namespace hallux::scenarios {

namespace {

/// Nobody follows teeth faster than they can saw.
constexpr double followed_mm_s = 5.0;
/// How fast a push is taken back [mm/s].
constexpr double release_mm_s = 40.0;
/// Unevenness is renewed by a part each so often, so that it stays about half a second: 0.9^2 +
/// 0.436^2 = 1.
constexpr double renewal_s = 0.05;
constexpr double kept_share = 0.9, renewed_share = 0.436;
/// Slower than this looks like no progress.
constexpr double progress_mm_s = 0.4;
constexpr double least_newton = 2.5, most_newton = 29.0;

}  // namespace

double handle_speed_mm_s(const Push& push, double wanted_newton, double felt_newton,
                         double seen_feed_mm_s) noexcept {
  const double seen_mm_s = std::clamp(seen_feed_mm_s, 0.0, followed_mm_s);
  const double missing_newton = wanted_newton - felt_newton;
  return std::clamp(seen_mm_s + missing_newton / push.brace_newton_s_per_mm, -release_mm_s,
                    push.lean_mm_s);
}

double WantedPush::next_newton(double meant_newton, double seen_feed_mm_s, double span_s) noexcept {
  until_renewed_s_ -= span_s;
  if (until_renewed_s_ <= 0.0) {
    until_renewed_s_ = renewal_s;
    uneven_share_ = kept_share * uneven_share_ +
                    renewed_share * random_.truncated_normal(0.0, push_.unevenness);
  }
  if (seen_feed_mm_s < progress_mm_s) {
    impatience_newton_ += push_.impatience_newton_per_s * span_s;
  } else {
    impatience_newton_ = std::max(0.0, impatience_newton_ - push_.impatience_newton_per_s * span_s);
  }
  return std::clamp(meant_newton * (1.0 + uneven_share_) + impatience_newton_, least_newton,
                    most_newton);
}

}  // namespace hallux::scenarios
