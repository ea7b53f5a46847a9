#include "ui/screens/pictures/contact_halo.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hallux::ui {

namespace {

/// Places on the tooth line, shares of its half width.
constexpr std::array<double, 5> places{-0.96, -0.48, 0.0, 0.48, 0.96};
/// What may lie before the teeth without hiding them: the teeth's own length.
constexpr double seen_within_mm = 0.6;

Vec3 tooth_in_bone_mm(const BoneSurface& bone, const RigidTransform& world_from_tool,
                      const simulator::Blade& blade, double place) {
  const RigidTransform bone_from_tool = inverse(bone.world_from_bone) * world_from_tool;
  return transform_point(bone_from_tool, Vec3(0.0, 0.5 * place * blade.width_mm, 0.0));
}

bool is_hidden(const BoneSurface& bone, const Vec3& tooth_in_bone_mm, const Vec3& eye_mm) {
  const Vec3 way_mm = tooth_in_bone_mm - eye_mm;
  const double away_mm = glm::length(way_mm);
  const auto hit = bone.tree.first_hit(eye_mm, way_mm / away_mm);
  return hit && hit->distance_mm < away_mm - seen_within_mm;
}

/// Most of the teeth are behind something, seen from the eye.
bool are_hidden(std::span<const BoneSurface> bones, const SawInScene& saw,
                const Vec3& eye_in_world_mm) {
  std::size_t hidden = 0;
  for (const double place : places) {
    const bool is_behind = std::ranges::any_of(bones, [&](const BoneSurface& bone) {
      return is_hidden(bone, tooth_in_bone_mm(bone, saw.world_from_tool, saw.blade, place),
                       transform_point(inverse(bone.world_from_bone), eye_in_world_mm));
    });
    hidden += is_behind ? 1U : 0U;
  }
  return 2 * hidden > places.size();
}

}  // namespace

std::optional<double> way_to_bone_mm(const BoneSurface& bone, const RigidTransform& world_from_tool,
                                     const simulator::Blade& blade) noexcept {
  const Vec3 feed =
      transform_direction(inverse(bone.world_from_bone) * world_from_tool, Vec3(1.0, 0.0, 0.0));
  std::optional<double> shortest_mm;
  for (const double place : places) {
    const Vec3 tooth_mm = tooth_in_bone_mm(bone, world_from_tool, blade, place);
    if (bone.tree.contains(tooth_mm)) return 0.0;
    const auto hit = bone.tree.first_hit(tooth_mm, feed);
    if (!hit || hit->distance_mm > halo_reach_mm) continue;
    if (!shortest_mm || hit->distance_mm < *shortest_mm) shortest_mm = hit->distance_mm;
  }
  return shortest_mm;
}

std::optional<ContactHalo> contact_halo(std::span<const BoneSurface> bones, const SawInScene& saw,
                                        const Vec3& eye_in_world_mm) noexcept {
  ContactHalo halo;
  halo.world_from_tool = saw.world_from_tool;
  halo.half_width_mm = 0.5 * saw.blade.width_mm;
  if (are_hidden(bones, saw, eye_in_world_mm)) {
    halo.kind = HaloKind::Behind;
    return halo;
  }
  std::optional<double> shortest_mm;
  for (const BoneSurface& bone : bones) {
    const std::optional<double> way_mm = way_to_bone_mm(bone, saw.world_from_tool, saw.blade);
    if (way_mm && (!shortest_mm || *way_mm < *shortest_mm)) shortest_mm = way_mm;
  }
  if (!shortest_mm) return std::nullopt;
  halo.distance_mm = *shortest_mm;
  halo.kind = *shortest_mm <= halo_contact_mm ? HaloKind::On : HaloKind::Before;
  return halo;
}

}  // namespace hallux::ui
