/// The blade against a planned face: tilt, distance, and place along the cut.
/// Shown in practice and not in an assessment.
#pragma once

#include <optional>

#include "scenarios/plan.h"
#include "scenarios/site/planned_passes.h"
#include "simulator/cutting/field/kerf.h"

namespace hallux::ui {

struct PlanReading {
  /// Of the blade against the face: about the tooth line (the teeth rise towards the waste), and
  /// about the feed.
  double pitch_rad = 0.0, roll_rad = 0.0;
  /// Between the normals of blade and face, at most a right angle.
  double angle_rad = 0.0;
  /// Of the kerf's kept side at the middle of the teeth from the face, positive in the waste; and
  /// where the stroke would end, if it went straight on.
  double distance_mm = 0.0;
  std::optional<double> end_distance_mm;
};

PlanReading read_against(const scenarios::PlannedCut& cut, const simulator::Blade& blade,
                         const RigidTransform& bone_from_tool) noexcept;

/// The distance of the face after a further way along the feed.
double distance_ahead_mm(const PlanReading& reading, double way_mm) noexcept;

/// The middle of the teeth in the plan's own directions.
struct PassReading {
  /// The pass that is nearest, of how many.
  std::size_t pass = 0, count = 1;
  /// From its middle, along the tooth line.
  double along_mm = 0.0;
  /// From the cut's entry, along the planned feed; below 0 before the bone.
  double depth_mm = 0.0;
};

PassReading read_passes(const scenarios::PlannedCut& cut, const scenarios::PlannedPasses& passes,
                        const RigidTransform& bone_from_tool) noexcept;

}  // namespace hallux::ui
