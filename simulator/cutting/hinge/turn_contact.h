/// How far a body can be turned about an axis until it touches another. Inside this corner only.
#pragma once

#include <optional>

#include "simulator/base/vector.h"
#include "simulator/mesh/indexed_mesh.h"

namespace hallux::simulator {

/// An axis with an open gap on one side of it. A positive turn about `axis` carries what stands
/// above the gap (where cross(toward_gap, axis) points) down into it.
struct TurnAxis {
  Vec3 point_mm{0.0, 0.0, 0.0};
  /// Unit.
  Vec3 axis{0.0, 1.0, 0.0};
  /// Unit, square to the axis.
  Vec3 toward_gap{0.0, 0.0, 1.0};
};

struct TurnContact {
  double angle_rad = 0.0;
  /// On the fixed body.
  Vec3 point_mm{0.0, 0.0, 0.0};
};

/// The smallest turn of `moved` in [0, most_rad] at which the two surfaces touch; nothing where
/// they do not.
/// units   contact nearer to the axis than `skip_radius_mm` is not looked for: there the bodies
///         share the bridge
/// needs   fixed lies below the plane through axis and gap, moved above it; most_rad below pi / 2
/// ensures exact up to rounding: corners against faces and edges against edges, each in closed form
/// source  docs/cutting.md, "The hinge"
std::optional<TurnContact> first_turn_contact(const IndexedMesh& fixed, const IndexedMesh& moved,
                                              const TurnAxis& axis, double skip_radius_mm,
                                              double most_rad);

}  // namespace hallux::simulator
