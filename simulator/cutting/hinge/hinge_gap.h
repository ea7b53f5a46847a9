/// The bridge of bone that a kerf leaves in its plane: how thick it is, or how far the blade went
/// beyond.
#pragma once

#include <optional>
#include <vector>

#include "simulator/cutting/field/region_outline.h"
#include "simulator/cutting/slice/section.h"

namespace hallux::simulator {

/// Where a bridge is planned: a line along which it bends, and the far cortex beyond it.
struct HingeLine {
  Vec3 point_in_bone_mm{0.0, 0.0, 0.0};
  /// Unit.
  Vec3 axis{0.0, 1.0, 0.0};
  /// Unit, square to the axis: from the line to the far cortex.
  Vec3 outward{0.0, 0.0, 1.0};
  /// Planned, in the row in which the bone reaches furthest outward.
  double thickness_mm = 1.0;
};

/// One line across the bridge: the points of the kerf's plane that lie `along_mm` along the hinge's
/// line. What is outward is measured along the hinge's outward direction, in a tilted plane too,
/// from the hinge's point [mm].
struct HingeRow {
  /// From the hinge's point, along its line.
  double along_mm = 0.0;
  /// How far outward the kerf reaches; where it opens nothing, where bone begins.
  double tip_mm = 0.0;
  /// The far surface.
  double far_mm = 0.0;
  /// Bone beyond the tip, voids left out.
  double intact_mm = 0.0;
  /// Whether the planned line runs through bone here: a line is straight and a cortex is not, so
  /// towards its ends the line lies outside, and nothing was planned to stay.
  bool is_apex = false;
  /// The kerf took bone in this row.
  bool is_opened = false;
};

struct HingeGap {
  /// Every row_step_mm of the section, ascending.
  std::vector<HingeRow> rows;
  /// The least intact bone of all apex rows, in each of which the far surface counts as lying as
  /// far out as it does in the row in which it lies furthest out. 0: cut through.
  double thickness_mm = 0.0;
  /// How far the kerf passes the far surface where that lies furthest out.
  double over_cut_mm = 0.0;
  /// The kerf took bone in an apex row.
  bool is_opened = false;
  /// In the row of the thickness, or of the over-cut.
  Vec3 tip_in_bone_mm{0.0, 0.0, 0.0};
  /// The far surface where it lies furthest out.
  Vec3 far_in_bone_mm{0.0, 0.0, 0.0};
  /// Of the bridge's inner edge: the mean tip of the apex rows.
  Vec3 middle_in_bone_mm{0.0, 0.0, 0.0};
};

inline constexpr double hinge_row_step_mm = 0.05;

/// The bridge in the section's plane.
/// needs   section is of the bone before this kerf; opened is outlined in the same plane
/// errors  nothing where the plane misses the bone, or stands across the hinge's line or outward
///         direction
/// source  docs/cutting.md, "The hinge"
std::optional<HingeGap> measure_hinge_gap(const Section& section, const RegionOutline& opened,
                                          const HingeLine& line);

}  // namespace hallux::simulator
