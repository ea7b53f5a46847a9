#include "ui/render/scene/camera.h"

#include <algorithm>
#include <cmath>
#include <glm/matrix.hpp>

#include "simulator/base/check.h"
#include "simulator/base/units.h"

namespace hallux::ui {

namespace {

constexpr Vec3 dorsal(0.0, 1.0, 0.0);
constexpr double near_share = 0.08;  ///< of the way from the eye to the screen plane
constexpr double far_shares = 12.0;
/// Ways on which so little more of the teeth is hidden are as good.
constexpr double hidden_alike = 0.2;
/// Cosine, about two degrees.
constexpr double already_looked_along = 0.9994;

struct Looking {
  Vec3 from{0.0, 0.0, 1.0};  ///< direction from the target to the viewer
  Vec3 up{0.0, 1.0, 0.0};
};

/// In the order of StandardView.
Looking looking(StandardView view) {
  const Looking views[] = {{Vec3(0.52, 0.62, -0.58), dorsal}, {dorsal, Vec3(1.0, 0.0, 0.0)},
                           {Vec3(0.0, 0.0, -1.0), dorsal},    {Vec3(0.0, 0.0, 1.0), dorsal},
                           {-dorsal, Vec3(1.0, 0.0, 0.0)},    {Vec3(1.0, 0.0, 0.0), dorsal},
                           {Vec3(-1.0, 0.0, 0.0), dorsal}};
  return views[static_cast<std::size_t>(view)];
}

DoubleMatrix4 frustum(const Vec2& low, const Vec2& high, double near, double far) {
  DoubleMatrix4 matrix(0.0);
  matrix[0][0] = 2.0 * near / (high.x - low.x);
  matrix[1][1] = 2.0 * near / (high.y - low.y);
  matrix[2][0] = (high.x + low.x) / (high.x - low.x);
  matrix[2][1] = (high.y + low.y) / (high.y - low.y);
  matrix[2][2] = -(far + near) / (far - near);
  matrix[2][3] = -1.0;
  matrix[3][2] = -2.0 * far * near / (far - near);
  return matrix;
}

/// What lies infinitely far behind is shifted by the eyes' whole distance: no more of the screen
/// than the limit.
double half_eye_distance(const Camera& camera, const Viewer& viewer) {
  const double limit_mm = viewer.parallax_limit * viewer.screen_width_mm;
  // The scene is a hand's size: as deep behind the screen as the screen is wide, which shows w / (w
  // + d) of the distance.
  const double deepest_share =
      viewer.screen_width_mm / (viewer.screen_width_mm + viewer.distance_mm);
  return 0.5 * std::min(viewer.eye_distance_mm, limit_mm / deepest_share) / camera.magnification;
}

}  // namespace

Camera orbited(const Camera& camera, double right_rad, double up_rad) noexcept {
  Camera turned = camera;
  const Quat about_dorsal = rotation_about(dorsal, -right_rad);
  const Quat about_right = rotation_about(Vec3(1.0, 0.0, 0.0), -up_rad);
  turned.world_from_view = normalised(about_dorsal * camera.world_from_view * about_right);
  return turned;
}

Camera panned(const Camera& camera, const Viewer& viewer, const Vec2& shares) noexcept {
  Camera moved = camera;
  const double width_mm = viewer.screen_width_mm / camera.magnification;
  moved.target_mm -= camera.world_from_view * Vec3(width_mm * shares, 0.0);
  return moved;
}

Camera zoomed(const Camera& camera, double factor) noexcept {
  Camera nearer = camera;
  nearer.magnification = std::clamp(camera.magnification * factor, 1.0, 60.0);
  return nearer;
}

Camera standard_view(const Camera& camera, StandardView view) noexcept {
  CHECK(view != StandardView::AlongBlade);
  Camera seen = camera;
  const Looking side = looking(view);
  const Vec3 z = glm::normalize(side.from);
  const Vec3 x = glm::normalize(glm::cross(side.up, z));
  seen.world_from_view = rotation_from_axes(x, glm::cross(z, x));
  return seen;
}

Camera along_blade(const Camera& camera, const RigidTransform& world_from_blade,
                   BladeSight sight) noexcept {
  const Vec3 from_in_blade = sight == BladeSight::OverHandle       ? Vec3(-1.0, 0.0, 0.0)
                             : sight == BladeSight::AcrossFromPlus ? Vec3(0.0, 1.0, 0.0)
                                                                   : Vec3(0.0, -1.0, 0.0);
  const Vec3 z = glm::normalize(transform_direction(world_from_blade, from_in_blade));
  // Over a blade that comes from dorsal one stands as for a view from dorsal: distal is up.
  const Vec3 up = std::abs(z.y) < 0.8 ? dorsal : Vec3(1.0, 0.0, 0.0);
  const Vec3 x = glm::normalize(glm::cross(up, z));
  Camera seen = camera;
  seen.world_from_view = rotation_from_axes(x, glm::cross(z, x));
  seen.target_mm = world_from_blade.translation_mm;
  return seen;
}

Camera seen_along_blade(const Camera& camera, const RigidTransform& world_from_blade,
                        const std::array<double, blade_sight_count>& hidden_shares) noexcept {
  const double least = *std::min_element(hidden_shares.begin(), hidden_shares.end());
  const Vec3 from = camera.world_from_view * Vec3(0.0, 0.0, 1.0);
  std::array<Camera, blade_sight_count> open{};
  std::size_t count = 0, nearest = 0, looked = blade_sight_count;
  double most = -2.0;
  for (std::size_t i = 0; i < blade_sight_count; ++i) {
    if (hidden_shares[i] > least + hidden_alike) continue;
    open[count] = along_blade(camera, world_from_blade, static_cast<BladeSight>(i));
    const double along = glm::dot(from, open[count].world_from_view * Vec3(0.0, 0.0, 1.0));
    if (along > most) {
      most = along;
      nearest = count;
    }
    if (along > already_looked_along) looked = count;
    ++count;
  }
  return looked < blade_sight_count ? open[(looked + 1) % count] : open[nearest];
}

Camera fitted(const Camera& camera, const Viewer& viewer, double radius_mm,
              double aspect) noexcept {
  Camera fit = camera;
  const double shorter_mm = viewer.screen_width_mm * std::min(1.0, 1.0 / aspect);
  fit.magnification = std::clamp(0.94 * shorter_mm / (2.0 * radius_mm), 1.0, 60.0);
  return fit;
}

EyeView view_of(const Camera& camera, const Viewer& viewer, Eye eye,
                double width_over_height) noexcept {
  const double width_mm = viewer.screen_width_mm / camera.magnification;
  const Vec2 half_mm(0.5 * width_mm, 0.5 * width_mm / width_over_height);
  const double distance_mm = viewer.distance_mm / camera.magnification;
  const Vec3 eye_mm(static_cast<double>(eye) * half_eye_distance(camera, viewer), 0.0, distance_mm);

  // The screen's frame: origin in its middle, which lies in front of the target.
  const RigidTransform world_from_screen{
      camera.world_from_view,
      camera.target_mm + camera.world_from_view * Vec3(0.0, 0.0, camera.target_depth_mm)};
  const RigidTransform eye_from_screen{Quat(1.0, 0.0, 0.0, 0.0), -eye_mm};

  EyeView view;
  view.world_from_view = camera.world_from_view;
  view.view_from_world = matrix_of(eye_from_screen * inverse(world_from_screen));
  view.eye_in_world_mm = transform_point(world_from_screen, eye_mm);
  const double near_mm = near_share * distance_mm;
  view.clip_from_view =
      frustum(near_share * (-half_mm - Vec2(eye_mm)), near_share * (half_mm - Vec2(eye_mm)),
              near_mm, far_shares * distance_mm);
  view.width_over_height = width_over_height;
  return view;
}

EyeView shifted(const EyeView& view, const Vec2& shares) noexcept {
  DoubleMatrix4 by(1.0);
  by[3][0] = 2.0 * shares.x;
  by[3][1] = 2.0 * shares.y;
  EyeView moved = view;
  moved.clip_from_view = by * view.clip_from_view;
  return moved;
}

Vec3 place_in_picture(const EyeView& view, const Vec3& point_in_world_mm) noexcept {
  const glm::dvec4 clip = view.clip_from_world() * glm::dvec4(point_in_world_mm, 1.0);
  const Vec3 place = Vec3(clip) / clip.w;
  return Vec3(0.5 + 0.5 * place.x, 0.5 - 0.5 * place.y, place.z);
}

Vec3 point_at(const EyeView& view, const Vec3& place) noexcept {
  const glm::dvec4 clip(2.0 * place.x - 1.0, 1.0 - 2.0 * place.y, place.z, 1.0);
  const glm::dvec4 point = glm::inverse(view.clip_from_world()) * clip;
  return Vec3(point) / point.w;
}

}  // namespace hallux::ui
