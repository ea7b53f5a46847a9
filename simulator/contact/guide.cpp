#include "simulator/contact/guide.h"

#include <algorithm>
#include <cmath>

namespace hallux::simulator {

namespace {

/// A spring beyond its play, of a deviation to either side.
struct PlaySpring {
  double play = 0.0, stiffness = 0.0, limit = 0.0;

  double pull(double deviation) const noexcept {
    const double beyond = std::max(0.0, std::abs(deviation) - play);
    const double size = std::min(limit, stiffness * beyond);
    return deviation < 0.0 ? size : -size;
  }
};

double share_of(Guidance guidance) noexcept {
  if (guidance == Guidance::None) return 0.0;
  return guide_share_of_stiffness * (guidance == Guidance::Soft ? guide_share_when_soft : 1.0);
}

}  // namespace

GuidePush guide_push(const RigidTransform& bone_from_tool, const GuidePlane& plane,
                     Guidance guidance, const GuideStrength& full) noexcept {
  const double share = share_of(guidance);
  const PlaySpring off{guide_play_mm, share * full.stiffness_newton_per_mm,
                       guide_share_of_limit * full.force_limit_newton};
  const PlaySpring turned{guide_play_rad, share * full.torsion_newton_mm_per_rad,
                          guide_share_of_limit * full.torque_limit_newton_mm};
  const Vec3& normal = plane.normal_in_bone;
  GuidePush push;
  if (!(share > 0.0)) return push;
  const double off_mm = glm::dot(normal, bone_from_tool.translation_mm) - plane.offset_mm;
  push.force_newton = off.pull(off_mm) * normal;

  // The blade has two faces; it turns the shorter way. A sine serves as its angle: where they
  // differ, the torque is at its limit.
  const Vec3 blade_normal = axis_z(bone_from_tool);
  const double side = glm::dot(blade_normal, normal) < 0.0 ? -1.0 : 1.0;
  const Vec3 way_back = side * glm::cross(blade_normal, normal);
  const double sine = length_of(way_back);
  if (sine > guide_play_rad) push.torque_newton_mm = (-turned.pull(sine) / sine) * way_back;
  return push;
}

}  // namespace hallux::simulator
