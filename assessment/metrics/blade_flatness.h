/// How straight the blade was led, from its poses while it cut. Inside this room only.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "simulator/base/vector.h"

namespace hallux::assessment {

/// A point of the tooth line (an end or its middle) at one tick of cutting.
struct ToothPoint {
  Vec3 point_in_bone_mm{0.0, 0.0, 0.0};
  std::int64_t tick = 0;
};

struct Flatness {
  /// 97.5th minus 2.5th percentile of the distances from their own plane.
  double flatness_mm = 0.0;
  /// Between two ticks a point goes no further off that plane than from one to the other: the
  /// greatest of these ways, for both percentiles.
  double bound_mm = 0.0;
  /// Of the point furthest from that plane.
  std::int64_t tick = 0;
  Vec3 point_in_bone_mm{0.0, 0.0, 0.0};
};

/// errors  nothing where the points lie on a line or are fewer than three
/// source  docs/metrics.md: the walls of a planar kerf are flat by construction, so the wall cannot
///         tell
std::optional<Flatness> measure_flatness(std::span<const ToothPoint> points);

}  // namespace hallux::assessment
