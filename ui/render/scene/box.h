/// A box along the axes of some frame, in millimetres; empty until something was added.
#pragma once

#include <limits>

#include "simulator/base/vector.h"

namespace hallux::ui {

struct Box {
  Vec3 low_mm{std::numeric_limits<double>::infinity()};
  Vec3 high_mm{-std::numeric_limits<double>::infinity()};

  bool is_empty() const noexcept { return low_mm.x > high_mm.x; }
  void add(const Vec3& point_mm) noexcept {
    low_mm = glm::min(low_mm, point_mm);
    high_mm = glm::max(high_mm, point_mm);
  }
  void add(const Box& other) noexcept {
    low_mm = glm::min(low_mm, other.low_mm);
    high_mm = glm::max(high_mm, other.high_mm);
  }
};

}  // namespace hallux::ui
