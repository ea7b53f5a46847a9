/// What a point remembers of a surface, so that most questions about it need no search.
/// Inside this corner only.
#pragma once

#include <cmath>
#include <optional>

#include "simulator/mesh/bvh.h"

namespace hallux::simulator {

/// The surface's distance where it was asked for last, or less. The answers are the same without
/// it.
struct SurfaceMemory {
  Vec3 asked_mm{0.0, 0.0, 0.0};
  /// Negative inside.
  double clearance_mm = 0.0;
  bool is_known = false;

  double moved_mm(const Vec3& point_mm) const noexcept { return length_of(point_mm - asked_mm); }
};

/// The surface's point nearest to one; nothing where none is nearer than `within_mm`. What is
/// remembered bounds the search: its answer is the same.
/// thread  any; allocates nothing
std::optional<NearestPoint> nearest_by_memory(const Bvh& surface, const Vec3& point_mm,
                                              double within_mm,
                                              const SurfaceMemory& memory) noexcept;
/// The distance to a surface that is not empty, negative inside [mm]; likewise.
double clearance_by_memory(const Bvh& surface, const Vec3& point_mm,
                           const SurfaceMemory& memory) noexcept;

}  // namespace hallux::simulator
