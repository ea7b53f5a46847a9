#include "ui/render/painters/tool_shadow.h"

#include <algorithm>
#include <cmath>
#include <variant>

#include "ui/render/scene/driver_model.h"

namespace hallux::ui {

namespace {

/// As in the shader: the light never quite grazes the blade's plane or runs along the handpiece.
constexpr double steepest_least = 0.02, across_least = 0.01;
/// A capsule without end: its radius, how soft its shadow is at the least, and how far from it the
/// shadow begins.
struct ShadowCapsule {
  double from_x_mm = 0.0, radius_mm = 0.0, soft_mm = 0.0, begins_mm = 0.0;
};
/// Beyond the first the softness grows by that with the way.
constexpr double softer = 0.10;

ShadowCapsule handpiece_of(const ToolShadow& shadow) noexcept {
  return {shadow.handpiece_from_mm, 7.5, 1.0, 0.5};
}
ShadowCapsule shaft_of(const ToolShadow& shadow) noexcept {
  return {0.0, shadow.shaft_radius_mm, 0.12, 0.15};
}
/// The shaft between a screw and its driver.
constexpr double screw_shaft_radius_mm = 1.6;

/// The formula is the shader's, the numbers are not of its single precision.
constexpr double rounding_mm = 0.05;

/// How far the ball's points may lie from the shadow's rim at its middle: the formula's slope times
/// the radius.
bool may_blade_shade(const ToolShadow& shadow, const Vec3& middle_mm, double radius_mm) noexcept {
  const Vec3& key = shadow.key_in_tool;
  const double rise = std::abs(key.z) < steepest_least ? steepest_least : key.z;
  const double slope = 1.0 / std::abs(rise);
  const double to_plane_mm = -middle_mm.z / rise;
  if (to_plane_mm < 0.15 - radius_mm * slope) return false;
  const Vec2 hit_mm = Vec2(middle_mm) + to_plane_mm * Vec2(key);
  const double outside_mm =
      std::max({-shadow.blade_depth_mm - hit_mm.x, hit_mm.x, -shadow.blade_half_width_mm - hit_mm.y,
                hit_mm.y - shadow.blade_half_width_mm});
  const double soft_mm = 0.25 + 0.10 * std::abs(to_plane_mm);
  return outside_mm - soft_mm < radius_mm * (1.0 + slope + 0.10 * slope);
}

bool may_capsule_shade(const ToolShadow& shadow, const ShadowCapsule& capsule,
                       const Vec3& middle_mm, double radius_mm) noexcept {
  const Vec2 across_mm(middle_mm.y, middle_mm.z);
  const Vec2 way(shadow.key_in_tool.y, shadow.key_in_tool.z);
  const double across_square = std::max(glm::dot(way, way), across_least);
  const double slope = glm::length(way) / across_square;
  const double along_mm = std::max(-glm::dot(across_mm, way) / across_square, 0.0);
  if (along_mm < capsule.begins_mm - radius_mm * slope) return false;
  const Vec3 passed_mm = middle_mm + along_mm * shadow.key_in_tool;
  const double beyond_mm = std::max(passed_mm.x - capsule.from_x_mm, 0.0);
  const double clearance_mm =
      glm::length(Vec3(passed_mm.y, passed_mm.z, beyond_mm)) - capsule.radius_mm;
  return clearance_mm - capsule.soft_mm - softer * along_mm <
         radius_mm * (1.0 + slope + softer * slope);
}

Vec3 key_in_tool(const RigidTransform& world_from_tool, const Float3& key_light) noexcept {
  return transform_direction(inverse(world_from_tool), Vec3(key_light));
}

}  // namespace

ToolShadow tool_shadow(const SawInScene& saw, const Float3& key_light) noexcept {
  return {.world_from_tool = saw.world_from_tool,
          .key_in_tool = key_in_tool(saw.world_from_tool, key_light),
          .blade_depth_mm = saw.blade.depth_mm,
          .blade_half_width_mm = 0.5 * saw.blade.width_mm,
          .handpiece_from_mm = -saw.blade.depth_mm - 2.0};
}

ToolShadow tool_shadow(const DriverInScene& driver, const Float3& key_light) noexcept {
  const bool has_screw = std::holds_alternative<simulator::Screwdriver>(driver.tool);
  return {.world_from_tool = driver.world_from_tool,
          .key_in_tool = key_in_tool(driver.world_from_tool, key_light),
          .shaft_radius_mm = has_screw ? screw_shaft_radius_mm : held_radius_mm(driver.tool),
          .handpiece_from_mm = chuck_x_mm(driver.tool) - 4.0};
}

std::optional<ToolShadow> tool_shadow(const Scene& scene, const Float3& key_light) noexcept {
  if (scene.saw) return tool_shadow(*scene.saw, key_light);
  if (scene.driver) return tool_shadow(*scene.driver, key_light);
  return std::nullopt;
}

const RigidTransform* world_from_shading_tool(const Scene& scene) noexcept {
  if (scene.saw) return &scene.saw->world_from_tool;
  return scene.driver ? &scene.driver->world_from_tool : nullptr;
}

bool may_shade(const ToolShadow& shadow, const Vec3& middle_in_tool_mm, double radius_mm) noexcept {
  const double reach_mm = radius_mm + rounding_mm;
  const bool has_blade = shadow.shaft_radius_mm <= 0.0;
  return (has_blade ? may_blade_shade(shadow, middle_in_tool_mm, reach_mm)
                    : may_capsule_shade(shadow, shaft_of(shadow), middle_in_tool_mm, reach_mm)) ||
         may_capsule_shade(shadow, handpiece_of(shadow), middle_in_tool_mm, reach_mm);
}

PixelTiles shaded_pixels(const Scene& scene, std::span<const ToolShadow> shadows,
                         const EyeView& view, PixelSize size) {
  PixelTiles tiles{size};
  for (const BoneInScene& bone : scene.bones) {
    const auto is_shaded = [&](const Vec3& middle_in_bone_mm, double radius_mm) {
      const Vec3 middle_mm = transform_point(bone.world_from_bone, middle_in_bone_mm);
      return std::ranges::any_of(shadows, [&](const ToolShadow& shadow) {
        return may_shade(shadow, transform_point(inverse(shadow.world_from_tool), middle_mm),
                         radius_mm);
      });
    };
    const Box box{bone.mesh->low_mm, bone.mesh->high_mm};
    add_parts(tiles, {box, bone.world_from_bone, view, size}, is_shaded);
  }
  return tiles;
}

}  // namespace hallux::ui
