/// The step of the operation at hand, and the guide that leads the hand in it.
/// Inside this corner only.
///
/// A guide leads to the planned plane until the step has a kerf of its own; from then on to that
/// kerf's plane, so that a further pass lies in the first one's. In a kerf its walls lead.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "simulator/contact/guide.h"

namespace hallux::simulator {

class GuideOfStep {
 public:
  /// The step after `step` is at hand now.
  void finish_step(std::int32_t step) noexcept { step_at_hand_ = std::int64_t{step} + 1; }
  /// That step is at hand again, with the kerf that was made in it.
  void reopen_step(std::int32_t step) noexcept { step_at_hand_ = step; }
  /// A kerf began in the step at hand, where the blade lies in it now.
  void note_own_kerf(const RigidTransform& bone_from_kerf) noexcept {
    const Vec3 normal = axis_z(bone_from_kerf);
    note_own_kerf({normal, glm::dot(normal, bone_from_kerf.translation_mm)});
  }
  void note_own_kerf(const GuidePlane& plane) noexcept {
    if (is_guided_step()) own_kerfs_[static_cast<std::size_t>(step_at_hand_)] = plane;
  }

  /// The plane that leads the hand now, borrowed from `plan` or from this; null where none does.
  const GuidePlane* plane(const GuidePlan& plan) const noexcept {
    if (plan.guidance == Guidance::None || !is_guided_step()) return nullptr;
    const auto step = static_cast<std::size_t>(step_at_hand_);
    if (!plan.of_step[step]) return nullptr;
    return own_kerfs_[step] ? &*own_kerfs_[step] : &*plan.of_step[step];
  }

 private:
  bool is_guided_step() const noexcept {
    return step_at_hand_ >= 0 && step_at_hand_ < std::int64_t{guided_steps_at_most};
  }

  std::int64_t step_at_hand_ = 0;
  /// Of each step, the kerf that began last in it.
  std::array<std::optional<GuidePlane>, guided_steps_at_most> own_kerfs_{};
};

}  // namespace hallux::simulator
