#include "simulator/contact/metal.h"

#include <algorithm>

namespace hallux::simulator {

std::int32_t metal_at(std::span<const Vec3> points_mm, std::span<const Capsule> metal) noexcept {
  const auto met = std::find_if(metal.begin(), metal.end(), [&](const Capsule& implant) {
    return std::any_of(points_mm.begin(), points_mm.end(), [&](const Vec3& point_mm) {
      return is_in_capsule({&implant, 1}, point_mm);
    });
  });
  return met == metal.end() ? -1 : static_cast<std::int32_t>(met - metal.begin());
}

}  // namespace hallux::simulator
