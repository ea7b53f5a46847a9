#include "tests/simulator/cutting/field/random_stamps.h"

#include <cmath>

namespace hallux::tests {

using namespace simulator;

FieldGrid small_grid() {
  return {.origin_mm = Vec2(-small_half_mm), .spacing_mm = 0.1, .u_count = 81, .v_count = 81};
}

RandomStamp random_stamp(Random& random) {
  const auto direction = [&] {
    const Vec2 any(random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0));
    const double length = glm::length(any);
    return length > 0.1 ? any / length : Vec2(0.0, 1.0);
  };
  RandomStamp stamp;
  const bool is_thin = random.uniform() < 0.4;
  stamp.blade.width_mm = is_thin ? random.uniform(0.01, 0.2) : random.uniform(0.2, 2.0);
  stamp.blade.depth_mm =
      random.uniform() < 0.3 ? random.uniform(0.01, 0.2) : random.uniform(0.5, 3.0);
  // Whole nodes now and then: sides that run through them.
  const double quantum_mm = random.uniform() < 0.3 ? 0.1 : 1e-3;
  const auto place = [&](double half_mm) {
    return Vec2(std::round(random.uniform(-half_mm, half_mm) / quantum_mm) * quantum_mm,
                std::round(random.uniform(-half_mm, half_mm) / quantum_mm) * quantum_mm);
  };
  stamp.from.tip_mm = place(1.1 * small_half_mm);
  stamp.from.direction = random.uniform() < 0.3 ? Vec2(0.0, -1.0) : direction();
  stamp.to = stamp.from;
  if (random.uniform() < 0.7) stamp.to.tip_mm += place(1.0);
  if (random.uniform() < 0.3) stamp.to.direction = direction();
  return stamp;
}

}  // namespace hallux::tests
