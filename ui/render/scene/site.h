/// What is drawn at the site of a cut besides bone and saw: what must not be touched, what still
/// holds, what came free, and where the teeth meet the bone. Plain data, as scene.h; each state has
/// a shape of its own beside its colour.
#pragma once

#include <cstdint>
#include <vector>

#include "simulator/base/transform.h"
#include "ui/render/scene/bone_mesh.h"

namespace hallux::ui {

/// A danger zone: a capsule, faint and dashed; lit, with a whole outline and rings, where the blade
/// is near.
struct ZoneInScene {
  Vec3 from_mm{0.0, 0.0, 0.0}, to_mm{0.0, 0.0, 0.0};
  double radius_mm = 1.0;
  /// Towards 0 it is not seen.
  double presence = 1.0;
  bool is_near = false;

  friend bool operator==(const ZoneInScene&, const ZoneInScene&) = default;
};

/// Corners of a closed loop in a plane.
using PlaneLoop = std::vector<Vec2>;

/// Bone that still stands in a kerf's plane, tinted and hatched, seen through the bone before it.
struct HeldBone {
  /// z is the kerf's normal.
  RigidTransform world_from_kerf;
  /// Outlines of the bone in that plane, holes likewise.
  std::vector<PlaneLoop> bone_mm;
  /// Outlines of what the kerf has opened there.
  std::vector<PlaneLoop> opened_mm;

  friend bool operator==(const HeldBone&, const HeldBone&) = default;
};

/// A piece that came free, shown by its outline alone: it may still be part of a bone of the scene.
struct FreePiece {
  const BoneMesh* mesh = nullptr;
  RigidTransform world_from_bone;

  friend bool operator==(const FreePiece&, const FreePiece&) = default;
};

enum class HaloKind : std::uint8_t {
  /// The teeth are in the air: a ring on the bone where they would meet it, the wider the further
  /// away they are.
  Before,
  /// They touch it: the ring lies close around them, and is filled.
  On,
  /// Bone hides them from the viewer: a dashed ring around them on what is seen there.
  Behind
};

/// A ring around the place where the teeth meet the bone.
struct ContactHalo {
  HaloKind kind = HaloKind::Before;
  RigidTransform world_from_tool;
  /// Of the tooth line.
  double half_width_mm = 6.0;
  /// From the teeth to the bone along the feed.
  double distance_mm = 0.0;

  friend bool operator==(const ContactHalo&, const ContactHalo&) = default;
};

}  // namespace hallux::ui
