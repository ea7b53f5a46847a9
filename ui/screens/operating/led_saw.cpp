#include "ui/screens/operating/led_saw.h"

#include "simulator/base/units.h"
#include "simulator/record/record.h"

namespace hallux::ui {

namespace {

using simulator::SteeredDevice;
using simulator::Switch;

constexpr double silence_s = static_cast<double>(SteeredDevice::silence_ticks) * step_s;

std::uint32_t bit(Switch value) noexcept { return static_cast<std::uint32_t>(value); }

}  // namespace

bool LedSaw::is_silent(double now_s) const noexcept { return now_s > led_s_ + silence_s; }

void LedSaw::lead(std::span<const simulator::PointerMotion> motions, const Quat& world_from_view,
                  double now_s) noexcept {
  for (const simulator::PointerMotion& motion : motions) {
    world_from_target_ = steered(world_from_target_, world_from_view, motion);
  }
  world_from_target_ = simulator::kept_within(world_from_target_, site_in_world_mm_, reach_mm);
  device_->aim(world_from_target_, (is_on_ ? bit(Switch::SawRuns) : 0U) |
                                       (is_irrigated_ ? bit(Switch::Irrigates) : 0U));
  led_s_ = now_s;
}

void LedSaw::release() noexcept {
  is_on_ = false;
  device_->aim(world_from_target_, 0);
}

}  // namespace hallux::ui
