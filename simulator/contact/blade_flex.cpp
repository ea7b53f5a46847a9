#include "simulator/contact/blade_flex.h"

#include <algorithm>

namespace hallux::simulator {

namespace {

/// Walks by the distance to the surface; nearer than this is there.
constexpr double near_mm = 0.01;
/// A middle line that grazes the surface approaches it endlessly: then it goes on in steps of this.
constexpr double step_mm = 0.1;

}  // namespace

double deflection_mm(const BladeBeam& beam, double side_force_newton) noexcept {
  const double inertia_mm4 =
      beam.width_mm * beam.thickness_mm * beam.thickness_mm * beam.thickness_mm / 12.0;
  const double length_mm = beam.free_length_mm;
  return side_force_newton * length_mm * length_mm * length_mm /
         (3.0 * steel_modulus_newton_per_mm2 * inertia_mm4);
}

double free_length_mm(const RigidTransform& bone_from_tool, double depth_mm,
                      const Wound& bone) noexcept {
  OfFragments<SurfaceMemory> memory;
  double from_collar_mm = 0.0;
  while (from_collar_mm < depth_mm) {
    const Vec3 point = transform_point(bone_from_tool, Vec3{from_collar_mm - depth_mm, 0.0, 0.0});
    const double clearance_mm = bone.clearance_mm(point, memory);
    if (clearance_mm <= near_mm) return from_collar_mm;
    from_collar_mm += std::max(step_mm, clearance_mm);
  }
  return depth_mm;
}

}  // namespace hallux::simulator
