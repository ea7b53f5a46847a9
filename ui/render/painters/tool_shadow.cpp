#include "ui/render/painters/tool_shadow.h"

#include <algorithm>
#include <cmath>

namespace hallux::ui {

namespace {

/// As in the shader: the light never quite grazes the blade's plane or runs along the handpiece.
constexpr double steepest_least = 0.02, across_least = 0.01;
constexpr double handpiece_radius_mm = 7.5;
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

bool may_handpiece_shade(const ToolShadow& shadow, const Vec3& middle_mm,
                         double radius_mm) noexcept {
  const Vec2 across_mm(middle_mm.y, middle_mm.z);
  const Vec2 way(shadow.key_in_tool.y, shadow.key_in_tool.z);
  const double across_square = std::max(glm::dot(way, way), across_least);
  const double slope = glm::length(way) / across_square;
  const double along_mm = std::max(-glm::dot(across_mm, way) / across_square, 0.0);
  if (along_mm < 0.5 - radius_mm * slope) return false;
  const Vec3 passed_mm = middle_mm + along_mm * shadow.key_in_tool;
  const double beyond_mm = std::max(passed_mm.x - shadow.handpiece_from_mm, 0.0);
  const double clearance_mm =
      glm::length(Vec3(passed_mm.y, passed_mm.z, beyond_mm)) - handpiece_radius_mm;
  return clearance_mm - 1.0 - 0.10 * along_mm < radius_mm * (1.0 + slope + 0.10 * slope);
}

}  // namespace

ToolShadow tool_shadow(const SawInScene& saw, const Float3& key_light) noexcept {
  return {saw.world_from_tool, transform_direction(inverse(saw.world_from_tool), Vec3(key_light)),
          saw.blade.depth_mm, 0.5 * saw.blade.width_mm, -saw.blade.depth_mm - 2.0};
}

bool may_shade(const ToolShadow& shadow, const Vec3& middle_in_tool_mm, double radius_mm) noexcept {
  const double reach_mm = radius_mm + rounding_mm;
  return may_blade_shade(shadow, middle_in_tool_mm, reach_mm) ||
         may_handpiece_shade(shadow, middle_in_tool_mm, reach_mm);
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
