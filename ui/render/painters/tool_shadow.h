/// The shadow of the tool in the hand on bones, by formula, and where of a picture it can fall. No
/// graphics.
///
/// The blade is a rectangle; a wire, a bit or a screw's shaft a thin capsule, the handpiece a thick
/// one, both without end. The shadow is softer the further away it falls from
/// (shaders/tool_shadow.glsl, whose numbers stand here once more). Forceps and implants cast none.
#pragma once

#include <optional>
#include <span>

#include "ui/render/painters/pixel_tiles.h"
#include "ui/render/scene/scene.h"

namespace hallux::ui {

struct ToolShadow {
  RigidTransform world_from_tool;
  /// Unit direction towards the light.
  Vec3 key_in_tool{0.0, 0.0, 1.0};
  double blade_depth_mm = 0.0, blade_half_width_mm = 0.0;
  /// Of what is in the blade's place, x <= 0 in the tool frame; 0: there is a blade.
  double shaft_radius_mm = 0.0;
  /// It lies behind, x <= handpiece_from_mm in the tool frame.
  double handpiece_from_mm = 0.0;

  friend bool operator==(const ToolShadow&, const ToolShadow&) = default;
};

/// frame   key_light is a unit direction of the world, towards the light
ToolShadow tool_shadow(const SawInScene& saw, const Float3& key_light) noexcept;
ToolShadow tool_shadow(const DriverInScene& driver, const Float3& key_light) noexcept;
/// The saw's; without a saw the driver's; without both none.
std::optional<ToolShadow> tool_shadow(const Scene& scene, const Float3& key_light) noexcept;
/// The pose of the tool that casts it; null where none does.
const RigidTransform* world_from_shading_tool(const Scene& scene) noexcept;

/// False where no point of the ball lies in the shadow; true may be said of one that the shadow
/// only comes near to.
bool may_shade(const ToolShadow& shadow, const Vec3& middle_in_tool_mm, double radius_mm) noexcept;

/// Where of a picture of this size any of the shadows can fall on the scene's bones.
PixelTiles shaded_pixels(const Scene& scene, std::span<const ToolShadow> shadows,
                         const EyeView& view, PixelSize size);

}  // namespace hallux::ui
