#include "simulator/contact/metal.h"

#include <algorithm>

namespace hallux::simulator {

bool meets_metal(std::span<const Vec3> points_in_body_mm, std::span<const Capsule> metal) noexcept {
  if (metal.empty()) return false;
  return std::any_of(points_in_body_mm.begin(), points_in_body_mm.end(),
                     [&](const Vec3& point_mm) { return is_in_capsule(metal, point_mm); });
}

}  // namespace hallux::simulator
