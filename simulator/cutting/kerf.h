/// A kerf: the plane a blade is frozen to, and the field of what it has covered there.
///
/// Kerf frame: origin and axes of the tool at the moment of freezing, said in the bone frame. x = feed direction,
/// y = along the tooth line, z = blade normal. The kerf is the slab |z| <= thickness / 2 over the opened region.
/// The field holds at each node the greatest inside-distance to any blade that was there, limited to +-2 node spacings:
/// above zero means opened. `max` makes it monotone and independent of the order and repetition of stamps. The limit is
/// what makes a stamp cheap: nodes deep inside hold the limit already and are skipped row by row, so that a small motion
/// costs the rim of the blade and not its area.
#pragma once

#include <cstdint>
#include <vector>

#include "simulator/base/transform.h"

namespace hallux::simulator {

struct BladeSize {
  double width_mm = 10.0;  ///< along the tooth line
  double depth_mm = 20.0;  ///< from the tooth line back to the collar
  double kerf_mm = 0.5;    ///< thickness of what is taken away
};

struct KerfPlane {
  RigidTransform bone_from_kerf;
  double thickness_mm = 0.5;
};

/// A blade in the kerf's plane: middle of the tooth line, and unit feed direction.
struct PlanarPose {
  Vec2 tip_mm{0.0, 0.0};
  Vec2 direction{1.0, 0.0};
};

/// The pose of the tool, projected to the kerf's plane.
PlanarPose planar_pose(const KerfPlane& plane, const RigidTransform& bone_from_tool) noexcept;

/// Nodes [first, last) in both directions; empty where first == last.
struct FieldWindow {
  std::int32_t u_first = 0, v_first = 0, u_last = 0, v_last = 0;

  bool is_empty() const noexcept { return u_first >= u_last || v_first >= v_last; }
};

/// The nodes of a field: node (i, j) lies at origin + spacing (i, j) in the kerf's plane.
struct FieldGrid {
  Vec2 origin_mm{-40.0, -40.0};
  double spacing_mm = 0.1;
  std::int32_t u_count = 801, v_count = 801;
};

class KerfField {
 public:
  /// Takes all its memory here; every node starts closed.
  explicit KerfField(const FieldGrid& grid);

  const FieldGrid& grid() const noexcept { return grid_; }
  /// Inside-distance at a node [mm]; not above 0 where bone still stands.
  float at(std::int32_t u, std::int32_t v) const noexcept;
  /// Bilinear between nodes; closed outside the grid.
  bool is_open(const Vec2& point_mm) const noexcept;
  /// Closes every node again, for another kerf.
  void reset() noexcept;

  /// Raises the field to the inside-distance of the hull of the blade's rectangles (x in [-depth, 0], y within
  /// +-width/2 of the tool frame) at `from` and `to`.
  /// shape   `changed` becomes the smallest window that holds every node that rose
  /// needs   blade sizes above zero, directions of unit length
  /// ensures the field never falls; order and repetition of stamps do not matter, bit for bit
  /// errors  none: total, allocates nothing; what lies outside the grid is not opened, poses that are not finite open
  ///         nothing
  /// thread  haptic (and, on its own copy, jobs)
  /// source  docs/cutting.md; thesis 4.4.2
  void stamp(const BladeSize& blade, const PlanarPose& from, const PlanarPose& to,
             FieldWindow& changed) noexcept;

 private:
  struct RowSpan {
    std::int32_t first = 0, last = 0;
  };
  struct HullRow;

  bool raise(std::size_t node, float inside_mm) noexcept;
  void raise_rim(const HullRow& row, std::int32_t first, std::int32_t last,
                 FieldWindow& changed) noexcept;
  void fill_deep(std::int32_t v, RowSpan wanted, FieldWindow& changed) noexcept;

  FieldGrid grid_;
  float limit_mm_;                ///< stored values lie within +-limit
  std::vector<float> inside_mm_;  ///< row by row
  std::vector<RowSpan>
      deep_;  ///< per row: nodes known to hold the limit; says nothing about the others
};

}  // namespace hallux::simulator
