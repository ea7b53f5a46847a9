/// Tilt and distance of the blade from a planned face, shown in practice and not in an assessment.
/// Inside this corner only.
#pragma once

#include "scenarios/plan.h"
#include "simulator/cutting/field/kerf.h"

namespace hallux::ui {

struct PlanReading {
  /// Of the blade against the face: about the tooth line (the teeth rise towards the waste), and
  /// about the feed.
  double pitch_rad = 0.0, roll_rad = 0.0;
  /// Of the kerf's kept side at the middle of the teeth from the face, positive in the waste.
  double distance_mm = 0.0;
};

PlanReading read_against(const scenarios::PlannedCut& cut, const simulator::Blade& blade,
                         const RigidTransform& bone_from_tool) noexcept;

}  // namespace hallux::ui
