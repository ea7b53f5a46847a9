#include "ui/jobs/devices/felt_wall.h"

namespace hallux::ui {

FeltWall::FeltWall(const simulator::DeviceLimits& limits, double newton_per_mm, const Vec3& grip_mm)
    : newton_per_mm_(newton_per_mm),
      depth_mm_(grip_mm.z),
      settings_(simulator::force_output_settings(limits, newton_per_mm, 1)) {
  settings_.scale = 1.0;
  settings_.passivity.spring_newton_per_mm = newton_per_mm;
}

Vec3 FeltWall::force_newton(const Vec3& grip_mm) noexcept {
  const Vec3 pushed{0.0, 0.0, -newton_per_mm_ * (grip_mm.z - depth_mm_)};
  return output_force(state_, settings_, {pushed, grip_mm}).force_in_world_newton;
}

}  // namespace hallux::ui
