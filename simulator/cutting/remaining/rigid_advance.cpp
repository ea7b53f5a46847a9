#include "simulator/cutting/remaining/rigid_advance.h"

#include <algorithm>
#include <cmath>

namespace hallux::simulator {

/// With W the angle between the two quaternions, the normalised sum turns fastest in the middle:
/// the quaternion by sin W / cos^2(W / 2) = 2 tan(W / 2) per whole motion, the body by twice that.
/// The chord c between the quaternions gives sin(W / 2) = c / 2 without a loss of digits for small
/// turns.
double greatest_speed_mm(const RigidMotion& motion, double radius_mm) noexcept {
  const Quat& start = motion.bone_from_start.rotation;
  const Quat& end = motion.bone_from_end.rotation;
  const double sign = glm::dot(start, end) < 0.0 ? -1.0 : 1.0;
  const Quat chord = end * sign - start;
  const double half_sine = 0.5 * std::sqrt(glm::dot(chord, chord));
  const double half_cosine = std::sqrt(std::max(0.0, 1.0 - half_sine * half_sine));
  const double way_mm =
      length_of(motion.bone_from_end.translation_mm - motion.bone_from_start.translation_mm);
  // The chord of two quaternions on one half of the sphere is at most sqrt(2): the cosine is above
  // 0.7.
  const double turn_rad = 4.0 * half_sine / half_cosine;
  // A margin for the rounding of the above.
  return (way_mm + turn_rad * radius_mm) * (1.0 + 1.0e-12);
}

}  // namespace hallux::simulator
