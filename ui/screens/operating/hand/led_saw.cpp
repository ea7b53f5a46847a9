#include "ui/screens/operating/hand/led_saw.h"

#include <algorithm>
#include <utility>

#include "simulator/base/units.h"
#include "simulator/record/record.h"

namespace hallux::ui {

namespace {

using simulator::PointerMotion;
using simulator::SteeredDevice;
using simulator::Switch;

/// A frame that took longer leads no further.
constexpr double longest_frame_s = 0.1;
constexpr double silence_s = static_cast<double>(SteeredDevice::silence_ticks) * step_s;

/// What of a motion the window has a part in.
PointerMotion led_part(const PointerMotion& motion, SteeredDevice::Led led) noexcept {
  if (led == SteeredDevice::Led::Pose) return motion;
  if (led == SteeredDevice::Led::Nothing) return {};
  PointerMotion turns;
  turns.turned_rad = motion.turned_rad;
  turns.rolled_rad = motion.rolled_rad;
  turns.is_fine = motion.is_fine;
  return turns;
}

}  // namespace

bool LedSaw::is_silent(double now_s) const noexcept { return now_s > led_s_ + silence_s; }

/// All of it is ordered anew: what a grip has switched on meanwhile stays on.
void LedSaw::order(Switch which, bool is_on) noexcept {
  const std::uint32_t others = switches() & ~bit(which);
  ordered_ = others | (is_on ? bit(which) : 0U);
  ++orders_;
}

void LedSaw::lead(std::span<const PointerMotion> motions, const Quat& world_from_view,
                  double now_s) noexcept {
  world_from_view_ = world_from_view;
  for (const PointerMotion& motion : motions)
    hand_ = steered(hand_, world_from_view, led_part(motion, led()));
  const RigidTransform placed = wanted();
  const double duration_s = std::clamp(now_s - led_s_, 0.0, longest_frame_s);
  world_from_target_ = bounded(placed, duration_s);
  // Where it was kept from following, the hand goes on from there.
  if (!is_lifted() && !(world_from_target_ == placed)) set_down();
  if (std::exchange(is_released_, false)) ++orders_;
  tell(ordered_);
  led_s_ = now_s;
}

RigidTransform LedSaw::wanted() noexcept {
  const RigidTransform placed = placing_.place(hand_);
  switch (led()) {
    case SteeredDevice::Led::Pose:
      return placed;
    case SteeredDevice::Led::Rotation:
      return {placed.rotation, seen_.world_from_tool.translation_mm};
    case SteeredDevice::Led::Nothing:
      break;
  }
  return seen_.world_from_tool;
}

RigidTransform LedSaw::bounded(const RigidTransform& world_from_target,
                               double duration_s) const noexcept {
  if (led() == SteeredDevice::Led::Nothing) return world_from_target;
  const RigidTransform near =
      is_led_by_window() ? simulator::kept_within(world_from_target, site_in_world_mm_, reach_mm)
                         : world_from_target;
  return rail_ ? railed(near, *rail_, duration_s) : near;
}

void LedSaw::tell(std::uint32_t switches) const noexcept {
  const bool is_held = rail_ && lies_in(*rail_, world_from_target_);
  device_->aim({world_from_target_, switches,
                is_held ? rail_->normal_in_world : Vec3{0.0, 0.0, 0.0}, orders_, is_lifted(),
                world_from_view_});
}

void LedSaw::release() noexcept {
  set_on(false);
  is_released_ = true;
  tell(0);
}

void LedSaw::take_over() {
  device_->hand_over(seen_.world_from_tool);
  hand_ = world_from_target_ = seen_.world_from_tool;
  set_down();
  ordered_ = 0;
}

}  // namespace hallux::ui
