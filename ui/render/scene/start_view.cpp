#include "ui/render/scene/start_view.h"

#include <cmath>

namespace hallux::ui {

Camera camera_of(const StartView& view, const RigidTransform& world_from_bone,
                 const Vec3& site_in_bone_mm, const Viewer& viewer, double aspect) noexcept {
  const double flat = std::cos(view.elevation_rad);
  const Vec3 towards_viewer(flat * std::cos(view.azimuth_rad), std::sin(view.elevation_rad),
                            flat * std::sin(view.azimuth_rad));
  // From straight above or below proximal is up, as for one who stands at the toes.
  const Vec3 up = flat > 1.0e-3 ? Vec3(0.0, 1.0, 0.0) : Vec3(-1.0, 0.0, 0.0);
  const Vec3 x = glm::normalize(glm::cross(up, towards_viewer));
  const Quat upright = rotation_from_axes(x, glm::cross(towards_viewer, x));
  const Quat rolled = upright * rotation_about(Vec3(0.0, 0.0, 1.0), view.roll_rad);
  Camera camera;
  camera.target_mm = transform_point(world_from_bone, site_in_bone_mm);
  camera.world_from_view = normalised(world_from_bone.rotation * rolled);
  return fitted(camera, viewer, view.radius_mm, aspect);
}

}  // namespace hallux::ui
