#include "ui/screens/operating/hand/led_saw.h"

#include <algorithm>

#include "simulator/base/units.h"
#include "simulator/record/record.h"

namespace hallux::ui {

namespace {

using simulator::SteeredDevice;
using simulator::Switch;

/// A frame that took longer leads no further.
constexpr double longest_frame_s = 0.1;
constexpr double silence_s = static_cast<double>(SteeredDevice::silence_ticks) * step_s;

}  // namespace

bool LedSaw::is_silent(double now_s) const noexcept { return now_s > led_s_ + silence_s; }

void LedSaw::lead(std::span<const simulator::PointerMotion> motions, const Quat& world_from_view,
                  double now_s) noexcept {
  for (const simulator::PointerMotion& motion : motions) {
    hand_ = steered(hand_, world_from_view, motion);
  }
  const RigidTransform placed = placing_.place(hand_);
  const double duration_s = std::clamp(now_s - led_s_, 0.0, longest_frame_s);
  world_from_target_ = bounded(placed, duration_s);
  // Where it was kept from following, the hand goes on from there.
  if (!is_lifted() && !(world_from_target_ == placed)) set_down();
  tell((is_on_ ? bit(Switch::SawRuns) : 0U) | (is_irrigated_ ? bit(Switch::Irrigates) : 0U));
  led_s_ = now_s;
}

RigidTransform LedSaw::bounded(const RigidTransform& world_from_target,
                               double duration_s) const noexcept {
  const RigidTransform near =
      simulator::kept_within(world_from_target, site_in_world_mm_, reach_mm);
  return rail_ ? railed(near, *rail_, duration_s) : near;
}

void LedSaw::tell(std::uint32_t switches) const noexcept {
  const bool is_held = rail_ && lies_in(*rail_, world_from_target_);
  device_->aim(
      {world_from_target_, switches, is_held ? rail_->normal_in_world : Vec3{0.0, 0.0, 0.0}});
}

void LedSaw::release() noexcept {
  is_on_ = false;
  tell(0);
}

}  // namespace hallux::ui
