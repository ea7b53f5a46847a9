#include "simulator/contact/surface_memory.h"

#include <limits>

namespace hallux::simulator {

namespace {

/// Above the rounding of a distance.
constexpr double rounding_mm = 1.0e-6;

}  // namespace

std::optional<NearestPoint> nearest_by_memory(const Bvh& surface, const Vec3& point_mm,
                                              double within_mm,
                                              const SurfaceMemory& memory) noexcept {
  if (memory.is_known) {
    const double most_mm = std::abs(memory.clearance_mm) + memory.moved_mm(point_mm) + rounding_mm;
    if (most_mm < within_mm) {
      const std::optional<NearestPoint> found = surface.nearest(point_mm, most_mm);
      if (found) return found;
    }
  }
  return surface.nearest(point_mm, within_mm);
}

double clearance_by_memory(const Bvh& surface, const Vec3& point_mm,
                           const SurfaceMemory& memory) noexcept {
  const double any_mm = std::numeric_limits<double>::infinity();
  const std::optional<NearestPoint> found = nearest_by_memory(surface, point_mm, any_mm, memory);
  if (!found) return any_mm;
  return found->is_inside ? -found->distance_mm : found->distance_mm;
}

}  // namespace hallux::simulator
