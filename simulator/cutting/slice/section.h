/// The section of a solid by a kerf: which parts of the bone the kerf's slab crosses, and when each
/// is covered.
#pragma once

#include <cstdint>
#include <vector>

#include "simulator/cutting/field/kerf.h"
#include "simulator/cutting/pieces/cut_solid.h"
#include "simulator/mesh/bvh.h"

namespace hallux::simulator {

/// One closed contour of the section at the kerf's middle plane, in the kerf's plane;
/// counter-clockwise around bone.
using Contour = std::vector<Vec2>;

/// A connected part of the slab: the skin between the kerf's two planes belongs together, and so
/// does what it encloses. A triangle reaches into the slab unless all its corners are at or above
/// +thickness/2, or all below -thickness/2.
struct SectionRegion {
  /// That reach into the slab here, ascending; each belongs to one region.
  std::vector<std::uint32_t> triangles;
  /// At the middle plane: outer ones counter-clockwise, holes clockwise; may be empty.
  std::vector<Contour> contours;
  /// Extent of the slab's part, in the kerf's plane.
  Vec2 min_mm{0.0, 0.0}, max_mm{0.0, 0.0};
  /// At the middle plane, holes taken off.
  double area_mm2 = 0.0;
};

struct Section {
  KerfPlane plane;
  /// Largest first.
  std::vector<SectionRegion> regions;
};

/// A kerf as far as it is open at one moment.
struct KerfOpening {
  KerfPlane plane;
  /// Around what the blade has covered, counter-clockwise; holes clockwise.
  std::vector<Contour> opened_mm;
};

/// What a field has open in a plane.
KerfOpening opening_of(const KerfPlane& plane, const KerfField& field);

/// The contact slice.
/// needs   solid is closed; bvh was built over solid.mesh
/// errors  none: a plane that misses gives no regions
Section slice_section(const CutSolid& solid, const Bvh& bvh, const KerfPlane& plane);

}  // namespace hallux::simulator
