/// The step of the operation at hand, and the guide that leads the hand in it.
/// Inside this corner only.
///
/// A guide leads until the step has a kerf of its own: from then on the kerf's walls do.
#pragma once

#include <cstdint>

#include "simulator/contact/guide.h"

namespace hallux::simulator {

class GuideOfStep {
 public:
  /// The step after `step` is at hand now.
  void finish_step(std::int32_t step) noexcept {
    step_at_hand_ = std::int64_t{step} + 1;
    has_own_kerf_ = false;
  }
  /// A kerf began in the step at hand.
  void note_own_kerf() noexcept { has_own_kerf_ = true; }

  /// The plane that leads the hand now, borrowed from `plan`; null where none does.
  const GuidePlane* plane(const GuidePlan& plan) const noexcept {
    if (plan.guidance == Guidance::None || has_own_kerf_ || step_at_hand_ < 0) return nullptr;
    const auto step = static_cast<std::size_t>(step_at_hand_);
    if (step >= plan.of_step.size() || !plan.of_step[step]) return nullptr;
    return &*plan.of_step[step];
  }

 private:
  std::int64_t step_at_hand_ = 0;
  bool has_own_kerf_ = false;
};

}  // namespace hallux::simulator
