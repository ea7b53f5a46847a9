/// A hole while it is bored: an axis that is frozen to the tool, and how far along it a tip has
/// been. Inside this room only.
///
///     skin
///      |  radius_mm
///     -|-------------.
///      o----------->  )    x: along the axis, into the bone
///     -|-------------'
///      0        depth_mm
///
/// The one rule for whoever follows recorded poses: begin_bore where an axis was frozen, open_bore
/// with every pose of the running tool in it. Nothing else opens bone.
#pragma once

#include "simulator/base/transform.h"
#include "simulator/cutting/hole/capsule.h"

namespace hallux::simulator {

struct Bore {
  /// Origin where the tip met the bone; x along the axis, into the bone.
  RigidTransform body_from_bore;
  double radius_mm = 1.0;
  /// Of the tip, at most so far [mm]; never falls.
  double depth_mm = 0.0;
};

/// The bore of a tool whose tip is `touch_depth_mm` in the bone.
Bore begin_bore(const RigidTransform& body_from_tool, double touch_depth_mm,
                double radius_mm) noexcept;
/// A wider bore along the same axis, not opened yet: for a screw over its guide wire.
Bore widened(const Bore& bore, double radius_mm) noexcept;
/// Opens the bore to the tip; a tip that lies less deep changes nothing.
void open_bore(Bore& bore, const RigidTransform& body_from_tool) noexcept;

/// Whether two axes are one, more or less by what poses are rounded by; x of each, the same way.
bool is_along(const RigidTransform& axis, const RigidTransform& other) noexcept;
/// The way of a point along the bore's axis [mm].
double way_along(const Bore& bore, const Vec3& point_in_body_mm) noexcept;
/// What it has opened: from one radius before the skin to where the tip was deepest.
Capsule capsule_of(const Bore& bore) noexcept;

}  // namespace hallux::simulator
