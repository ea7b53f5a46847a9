#include "simulator/cutting/slice/plane_lattice.h"

#include <algorithm>

namespace hallux::simulator {

namespace {

constexpr double half_size_steps = 67108863.0;  // 2^26 - 1

/// floor(steps + 0.5); without -march the library's floor is a call.
std::int64_t nearest_step(double steps) noexcept {
  const double shifted = steps + 0.5;
  const auto towards_zero = static_cast<std::int64_t>(shifted);
  return towards_zero - (static_cast<double>(towards_zero) > shifted ? 1 : 0);
}

}  // namespace

PlaneLattice::PlaneLattice(const Vec2& min_mm, const Vec2& max_mm) noexcept
    : middle_mm_(0.5 * (min_mm + max_mm)) {
  const double half_size_mm = std::max(max_mm.x - middle_mm_.x, max_mm.y - middle_mm_.y);
  while (half_size_mm > step_mm_ * half_size_steps) step_mm_ *= 2.0;
}

LatticePoint PlaneLattice::snap(const Vec2& place_mm) const noexcept {
  const Vec2 steps = (place_mm - middle_mm_) / step_mm_;
  return {nearest_step(steps.x), nearest_step(steps.y)};
}

std::int64_t PlaneLattice::snap_height(double height_mm) const noexcept {
  return nearest_step(height_mm / step_mm_);
}

}  // namespace hallux::simulator
