#include "scenarios/hands/hand_senses.h"

#include <algorithm>

#include "simulator/base/units.h"

namespace hallux::scenarios {

namespace {

/// The eye's error is renewed by a part at each glance, so that it stays about a second: 0.98^2 +
/// 0.2^2 = 1.
constexpr std::int64_t ticks_per_glance = 20;
constexpr double kept_share = 0.98, renewed_share = 0.2;
constexpr double follow_s = 0.2;

}  // namespace

HandSenses::HandSenses(const Perception& perception, Random random) noexcept
    : reaction_ticks_(
          std::min(capacity - 1, static_cast<std::size_t>(perception.reaction_s / step_s + 0.5))),
      eye_mm_(perception.eye_mm),
      random_(random) {}

void HandSenses::observe(const Sensed& now, std::int64_t ticks) noexcept {
  for (std::int64_t i = 0; i < ticks; ++i) {
    past_[next_] = now;
    next_ = (next_ + 1) % capacity;
    known_ = std::min(known_ + 1, capacity);
  }
  ticks_to_glance_ -= ticks;
  if (ticks_to_glance_ <= 0) {
    ticks_to_glance_ = ticks_per_glance;
    eye_error_mm_ =
        kept_share * eye_error_mm_ + renewed_share * random_.truncated_normal(0.0, eye_mm_);
  }
  const std::size_t ago = std::min(reaction_ticks_, known_ - 1);
  noticed_ = past_[(next_ + capacity - 1 - ago) % capacity];
  if (known_ == static_cast<std::size_t>(ticks)) followed_feed_mm_ = noticed_.feed_mm;
  feed_mm_s_ = (noticed_.feed_mm - followed_feed_mm_) / follow_s;
  followed_feed_mm_ += feed_mm_s_ * static_cast<double>(ticks) * step_s;
  noticed_.feed_mm += eye_error_mm_;
}

}  // namespace hallux::scenarios
