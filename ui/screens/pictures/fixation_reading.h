/// The tool's axis against a planned wire or screw, and a fragment against its planned place.
/// Shown in practice and not in an assessment.
#pragma once

#include <cstddef>

#include "scenarios/plan.h"

namespace hallux::ui {

struct ImplantReading {
  /// From the planned entry to the axis, square to the planned direction, bone frame.
  Vec3 off_in_bone_mm{0.0, 0.0, 0.0};
  double entry_mm = 0.0;
  /// Between the axes.
  double direction_rad = 0.0;
  /// Of the tip beyond the planned entry, along the planned direction; below 0 before it.
  double depth_mm = 0.0;
};

ImplantReading read_implant(const scenarios::PlannedImplant& planned,
                            const RigidTransform& bone_from_tool) noexcept;

struct ShiftReading {
  /// Of the place that the fragment holds, from where it is to where it is planned, bone frame.
  Vec3 off_in_bone_mm{0.0, 0.0, 0.0};
  double off_mm = 0.0;
  /// Of that place, so far.
  double moved_mm = 0.0;
  /// From its orientation to the planned one, axis times angle, bone frame; and how much that is.
  Vec3 turn_left_in_bone_rad{0.0, 0.0, 0.0};
  double turned_rad = 0.0;
};

/// shift  of the plan's
ShiftReading read_shift(const scenarios::Plan& plan, std::size_t shift,
                        const RigidTransform& bone_from_fragment) noexcept;

}  // namespace hallux::ui
