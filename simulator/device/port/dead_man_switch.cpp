#include "simulator/device/port/dead_man_switch.h"

#include <algorithm>

namespace hallux::simulator {

Vec3 DeadManSwitch::allowed(const SaidForce& newest, Time now, bool may_push) noexcept {
  const bool is_new = newest.number != number_;
  number_ = newest.number;
  if (is_new) said_ = now;
  const bool is_held =
      number_ != 0 && now - said_ <= patience && may_push && is_finite(newest.in_device_newton);
  if (!is_held) {
    is_released_ = true;
    return {0.0, 0.0, 0.0};
  }
  if (is_released_) began_ = now;
  is_released_ = false;
  const double share = std::chrono::duration<double>(now - began_) / soft_start;
  return std::clamp(share, 0.0, 1.0) * newest.in_device_newton;
}

}  // namespace hallux::simulator
