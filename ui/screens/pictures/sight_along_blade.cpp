#include "ui/screens/pictures/sight_along_blade.h"

#include <algorithm>
#include <cmath>

namespace hallux::ui {

namespace {

constexpr std::array<double, 7> places{-0.96, -0.64, -0.32, 0.0, 0.32, 0.64, 0.96};
/// The teeth are asked about a little before the bone that they touch.
constexpr double before_teeth_mm = 0.8;
/// Between the line of sight and the feed. Who looks on from 20 degrees sees the teeth beside the
/// handle (a grip of 9 mm, 30 mm behind them); only nearer to the feed it lies before them.
constexpr double faint_within_rad = 0.12, whole_beyond_rad = 0.34;
constexpr double faint = 0.10;

bool is_hidden(std::span<const BoneSurface> bones, const Vec3& tooth_mm, const Vec3& towards_eye) {
  return std::ranges::any_of(bones, [&](const BoneSurface& bone) {
    const RigidTransform bone_from_world = inverse(bone.world_from_bone);
    return bone.tree
        .first_hit(transform_point(bone_from_world, tooth_mm),
                   transform_direction(bone_from_world, towards_eye))
        .has_value();
  });
}

}  // namespace

std::array<double, blade_sight_count> hidden_along_blade(std::span<const BoneSurface> bones,
                                                         const RigidTransform& world_from_tool,
                                                         const simulator::Blade& blade) noexcept {
  std::array<double, blade_sight_count> shares{};
  for (std::size_t sight = 0; sight < blade_sight_count; ++sight) {
    const Camera camera = along_blade({}, world_from_tool, static_cast<BladeSight>(sight));
    const Vec3 towards_eye = camera.world_from_view * Vec3(0.0, 0.0, 1.0);
    for (const double place : places) {
      const Vec3 tooth_mm = transform_point(
          world_from_tool, Vec3(-before_teeth_mm, 0.5 * place * blade.width_mm, 0.0));
      if (is_hidden(bones, tooth_mm, towards_eye)) shares[sight] += 1.0 / places.size();
    }
  }
  return shares;
}

double handpiece_presence_from(const RigidTransform& world_from_tool,
                               const Vec3& eye_in_world_mm) noexcept {
  const Vec3 sight = glm::normalize(world_from_tool.translation_mm - eye_in_world_mm);
  const Vec3 feed = transform_direction(world_from_tool, Vec3(1.0, 0.0, 0.0));
  const double angle_rad = std::acos(std::clamp(glm::dot(sight, feed), -1.0, 1.0));
  const double share =
      std::clamp((angle_rad - faint_within_rad) / (whole_beyond_rad - faint_within_rad), 0.0, 1.0);
  return faint + (1.0 - faint) * share;
}

}  // namespace hallux::ui
