/// Tools in the hand besides the saw, and what they leave in bone, to be seen. Plain data, part of
/// scene.h. Inside this corner only.
#pragma once

#include <vector>

#include "simulator/base/transform.h"
#include "simulator/tool/tray.h"

namespace hallux::ui {

/// A wire driver, a drill or a screwdriver with what it holds.
struct DriverInScene {
  /// Origin at the tip, +x from the handpiece along the axis.
  RigidTransform world_from_tool;
  /// Any but a saw.
  simulator::Tool tool = simulator::Drill{};
  bool is_running = false;
  /// About its axis, while it runs.
  double turned_rad = 0.0;
  /// Of the handpiece; towards 0 it is seen through wherever it is. What it holds stays.
  double handpiece_presence = 1.0;

  friend bool operator==(const DriverInScene&, const DriverInScene&) = default;
};

/// Forceps that hold a piece, or are about to.
struct ForcepsInScene {
  /// Origin between the points of the jaws, +x from the handles to them, z the normal of the plane
  /// in which they open.
  RigidTransform world_from_tool;
  double opening_mm = 8.0;
  /// Of the handles; towards 0 they are seen through wherever they are. The jaws stay.
  double handle_presence = 1.0;

  friend bool operator==(const ForcepsInScene&, const ForcepsInScene&) = default;
};

/// A wire or a screw that stands in bone, or is planned to.
struct ImplantInScene {
  /// Origin at the tip, +x along the axis towards it.
  RigidTransform world_from_tool;
  /// A wire driver or a screwdriver.
  simulator::Tool tool = simulator::WireDriver{};
  /// Translucent, in the colour of what is planned.
  bool is_planned = false;

  friend bool operator==(const ImplantInScene&, const ImplantInScene&) = default;
};

/// The rim of a hole on a bone's skin: the last point joins the first.
struct HoleInScene {
  std::vector<Vec3> rim_mm;
  /// Out of the bone, along the hole.
  Vec3 outward{0.0, 0.0, 1.0};

  friend bool operator==(const HoleInScene&, const HoleInScene&) = default;
};

}  // namespace hallux::ui
