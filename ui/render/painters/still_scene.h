/// What of a scene stands still from picture to picture, the bones as one sees them, and where two
/// pictures of it differ. No graphics.
///
///     still     bones with light on them, ground    drawn again only where they are cut, lit
///                                                   again where a tool's shadow moves
///     moving    tools and what they leave, lines,   drawn over it in every picture
///               chips, ghosts
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "ui/render/painters/pixel_box.h"
#include "ui/render/scene/scene.h"

namespace hallux::ui {

struct StillBone {
  std::uint64_t mesh_id = 0, look_id = 0;
  RigidTransform world_from_bone;
  double presence = 1.0;
  std::optional<SignedMap> map;
  std::optional<CutAway> cut_away;

  friend bool operator==(const StillBone&, const StillBone&) = default;
};

struct StillScene {
  EyeView view;
  double pixel_scale = 1.0;
  std::vector<StillBone> bones;
  Ground ground = Ground::Dark;
  Vec2 light_place{0.5, 0.5};

  friend bool operator==(const StillScene&, const StillScene&) = default;
};

StillScene still_scene(const Scene& scene, const EyeView& view, double pixel_scale);

/// The pixels of a picture of this size where that scene's bones changed.
/// shape   changed one for each bone, in its frame
PixelBox changed_pixels(const StillScene& scene, std::span<const Box> changed, PixelSize size);

}  // namespace hallux::ui
