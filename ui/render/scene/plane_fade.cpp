#include "ui/render/scene/plane_fade.h"

#include <algorithm>
#include <cmath>

namespace hallux::ui {

namespace {

/// Of a line beside its rectangle: there the rectangle says most of it.
constexpr double presence_beside_rectangle = 0.75;
constexpr double tick_mm = 2.0;

}  // namespace

double sight_angle_rad(const RigidTransform& world_from_plane,
                       const Vec3& eye_in_world_mm) noexcept {
  const Vec3 normal = world_from_plane.rotation * Vec3(0.0, 0.0, 1.0);
  const Vec3 sight = glm::normalize(world_from_plane.translation_mm - eye_in_world_mm);
  return std::asin(std::min(std::abs(glm::dot(normal, sight)), 1.0));
}

double face_on_share(const RigidTransform& world_from_plane, const Vec3& eye_in_world_mm) noexcept {
  const double angle_rad = sight_angle_rad(world_from_plane, eye_in_world_mm);
  const double share =
      std::clamp((angle_rad - edge_on_rad) / (face_on_rad - edge_on_rad), 0.0, 1.0);
  return share * share * (3.0 - 2.0 * share);
}

CuttingLine line_of(const PlaneGhost& plane, const Vec3& eye_in_world_mm) noexcept {
  const double edge_on = 1.0 - face_on_share(plane.world_from_plane, eye_in_world_mm);
  CuttingLine line{.world_from_plane = plane.world_from_plane,
                   .half_mm = plane.half_mm,
                   .width_pixels = plane.line_pixels,
                   .ink = plane.ink,
                   .is_dashed = true};
  line.tick_mm = edge_on > 0.5 ? tick_mm : 0.0;
  line.presence = presence_beside_rectangle + (1.0 - presence_beside_rectangle) * edge_on;
  return line;
}

std::vector<CuttingLine> all_lines(const Scene& scene, const Vec3& eye_in_world_mm) {
  std::vector<CuttingLine> lines = scene.lines;
  for (const PlaneGhost& plane : scene.planes) {
    if (plane.has_line) lines.push_back(line_of(plane, eye_in_world_mm));
  }
  return lines;
}

}  // namespace hallux::ui
