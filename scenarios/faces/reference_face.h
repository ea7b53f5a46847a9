/// A finished bone face on one patient, and where it ends.
/// Inside this corner only.
#pragma once

#include <limits>
#include <optional>

#include "simulator/base/vector.h"

namespace hallux::scenarios {

/// A finished bone face: points p with normal . p = offset; the bone on the side of the normal is
/// waste, or lies beyond the kerf.
struct ReferenceFace {
  Vec3 normal{0.0, 0.0, -1.0};
  double offset_mm = 0.0;
};

/// The part of a face that is cut: points p with along . (p - from) >= 0 and across . (p - from)
/// between the limits. Both directions lie in the face, of unit length and square to each other.
struct FaceWindow {
  Vec3 from_in_bone_mm{0.0, 0.0, 0.0};
  Vec3 along{1.0, 0.0, 0.0}, across{0.0, 1.0, 0.0};
  double low_mm = -std::numeric_limits<double>::infinity();
  double high_mm = std::numeric_limits<double>::infinity();
};

/// Of a point of the face.
bool lies_within(const FaceWindow& window, const Vec3& point_in_bone_mm) noexcept;

}  // namespace hallux::scenarios
