/// The saw's shadow on bones, by formula, and where of a picture it can fall. Inside this room
/// only; no graphics.
///
/// The blade is a rectangle, the handpiece a capsule without end; the shadow is softer the further
/// away it falls from (shaders/tool_shadow.glsl, whose numbers stand here once more).
#pragma once

#include <span>

#include "ui/render/painters/pixel_tiles.h"
#include "ui/render/scene/scene.h"

namespace hallux::ui {

struct ToolShadow {
  RigidTransform world_from_tool;
  /// Unit direction towards the light.
  Vec3 key_in_tool{0.0, 0.0, 1.0};
  double blade_depth_mm = 0.0, blade_half_width_mm = 0.0;
  /// It lies behind, x <= handpiece_from_mm in the tool frame.
  double handpiece_from_mm = 0.0;

  friend bool operator==(const ToolShadow&, const ToolShadow&) = default;
};

/// frame   key_light is a unit direction of the world, towards the light
ToolShadow tool_shadow(const SawInScene& saw, const Float3& key_light) noexcept;

/// False where no point of the ball lies in the shadow; true may be said of one that the shadow
/// only comes near to.
bool may_shade(const ToolShadow& shadow, const Vec3& middle_in_tool_mm, double radius_mm) noexcept;

/// Where of a picture of this size any of the shadows can fall on the scene's bones.
PixelTiles shaded_pixels(const Scene& scene, std::span<const ToolShadow> shadows,
                         const EyeView& view, PixelSize size);

}  // namespace hallux::ui
