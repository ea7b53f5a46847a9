/// Points and poses in JSON for other programs. Inside this corner only.
#pragma once

#include <nlohmann/json.hpp>

#include "simulator/base/transform.h"

namespace hallux::ui {

inline nlohmann::ordered_json vector_json(const Vec3& vector) {
  return {vector.x, vector.y, vector.z};
}

/// Row by row; a point is a column of four, the last of them 1.
inline nlohmann::ordered_json matrix_json(const RigidTransform& transform) {
  const Vec3 x = axis_x(transform), y = axis_y(transform), z = axis_z(transform);
  const Vec3& origin = transform.translation_mm;
  return {{x.x, y.x, z.x, origin.x},
          {x.y, y.y, z.y, origin.y},
          {x.z, y.z, z.z, origin.z},
          {0.0, 0.0, 0.0, 1.0}};
}

}  // namespace hallux::ui
