/// One integer lattice over a kerf's plane, and exact questions on it between bone and opened
/// region. Inside this corner only.
///
/// The lattice decides questions only; positions that go into a mesh stay as they are. Its step is
/// 2^-20 mm within 64 mm of its middle, so that every determinant is exact in 64 bits; for more
/// reach the step doubles until it fits.
///
/// Bone and region may touch in every possible way: a corner on an edge, an edge along an edge. The
/// region is therefore thought to be shifted by (e, e^2) for an endlessly small e > 0 (Edelsbrunner
/// and Muecke 1990, simulation of simplicity, for two sets of which one moves). Then no corner lies
/// on a line of the other set, and every answer below is that of one and the same shifted
/// configuration: crossings, windings and containments always fit together.
#pragma once

#include <cstdint>

#include "simulator/base/vector.h"

namespace hallux::simulator {

struct LatticePoint {
  /// Within +-2^26.
  std::int64_t u = 0, v = 0;

  friend bool operator==(const LatticePoint&, const LatticePoint&) = default;
};

class PlaneLattice {
 public:
  PlaneLattice() = default;
  /// The finest lattice that reaches over the box.
  PlaneLattice(const Vec2& min_mm, const Vec2& max_mm) noexcept;

  LatticePoint snap(const Vec2& place_mm) const noexcept;
  std::int64_t snap_height(double height_mm) const noexcept;

 private:
  Vec2 middle_mm_{0.0, 0.0};
  double step_mm_ = 1.0 / 1048576.0;
};

/// Twice the signed area of a triangle: positive where a, b, c turn left. Exact.
constexpr std::int64_t turn(const LatticePoint& a, const LatticePoint& b,
                            const LatticePoint& c) noexcept {
  return (b.u - a.u) * (c.v - a.v) - (b.v - a.v) * (c.u - a.u);
}

constexpr int sign_of(std::int64_t value) noexcept { return (value > 0) - (value < 0); }

/// +1 where the shifted region corner lies left of the bone's line from a to b, -1 right of it; 0
/// only where a == b.
constexpr int side_of_corner(const LatticePoint& a, const LatticePoint& b,
                             const LatticePoint& corner) noexcept {
  if (const int side = sign_of(turn(a, b, corner)); side != 0) return side;
  if (a.v != b.v) return sign_of(a.v - b.v);
  return sign_of(b.u - a.u);
}

/// +1 where the bone's point lies left of the shifted region edge from r to s, -1 right of it; 0
/// only where r == s.
constexpr int side_of_bone(const LatticePoint& r, const LatticePoint& s,
                           const LatticePoint& bone) noexcept {
  if (const int side = sign_of(turn(r, s, bone)); side != 0) return side;
  if (r.v != s.v) return sign_of(s.v - r.v);
  return sign_of(r.u - s.u);
}

/// What the shifted region edge from r to s adds to the winding of its loop around the bone's
/// point.
constexpr int winding_of_region_edge(const LatticePoint& r, const LatticePoint& s,
                                     const LatticePoint& bone) noexcept {
  const bool begins_above = r.v >= bone.v, ends_above = s.v >= bone.v;
  if (begins_above == ends_above) return 0;
  const int side = side_of_bone(r, s, bone);
  if (ends_above) return side > 0 ? 1 : 0;
  return side < 0 ? -1 : 0;
}

/// What the bone's edge from a to b adds to the winding of its loop around the shifted region
/// corner.
constexpr int winding_of_bone_edge(const LatticePoint& a, const LatticePoint& b,
                                   const LatticePoint& corner) noexcept {
  const bool begins_above = a.v > corner.v, ends_above = b.v > corner.v;
  if (begins_above == ends_above) return 0;
  const int side = side_of_corner(a, b, corner);
  if (ends_above) return side > 0 ? 1 : 0;
  return side < 0 ? -1 : 0;
}

}  // namespace hallux::simulator
