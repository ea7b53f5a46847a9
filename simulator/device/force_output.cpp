#include "simulator/device/force_output.h"

#include <algorithm>
#include <cmath>

#include "simulator/base/check.h"

namespace hallux::simulator {

namespace {

constexpr double longest_tick_s = 0.003;
constexpr double shortest_tick_s = 0.0005;

bool is_possible(const DeviceLimits& limits) noexcept {
  return limits.force_newton > 0.0 && limits.continuous_force_newton > 0.0 &&
         limits.thermal_time_s > 0.0 && limits.stiffness_newton_per_mm > 0.0 &&
         limits.damping_newton_s_per_mm >= 0.0 && limits.slew_newton_per_s > 0.0;
}

/// No force, and all that a contact has gathered is forgotten; only the motors stay warm.
DeviceForce stop(ForceOutputState& state, ForceLimit why) noexcept {
  const ThermalBudget thermal = state.thermal;
  state = {};
  state.thermal = thermal;
  return {{0.0, 0.0, 0.0}, bit(why)};
}

/// At most `limit_newton` long, in its own direction.
bool shorten(Vec3& force_newton, double limit_newton) noexcept {
  const double length_newton = length_of(force_newton);
  if (!(length_newton > limit_newton)) return false;
  force_newton *= limit_newton / length_newton;
  return true;
}

/// Within the slew of what was sent before.
bool approach(Vec3& force_newton, const Vec3& before_newton, double way_newton) noexcept {
  Vec3 change_newton = force_newton - before_newton;
  if (!shorten(change_newton, way_newton)) return false;
  force_newton = before_newton + change_newton;
  return true;
}

Vec3 started(ForceOutputState& state, const ForceOutputSettings& settings, const Vec3& force_newton,
             double duration_s, std::uint32_t& limits) noexcept {
  state.started_share = std::min(1.0, state.started_share + duration_s / settings.soft_start_s);
  if (state.started_share < 1.0) limits |= bit(ForceLimit::SoftStart);
  return state.started_share * force_newton;
}

void limit(Vec3& force_newton, const ForceOutputState& state, const ForceOutputSettings& settings,
           double duration_s, std::uint32_t& limits) noexcept {
  if (shorten(force_newton, settings.force_newton)) limits |= bit(ForceLimit::Greatest);
  if (approach(force_newton, state.sent_newton, settings.slew_newton_per_s * duration_s)) {
    limits |= bit(ForceLimit::Slew);
  }
  // Last, and after the slew: heat allows less so slowly that no step comes of it.
  if (shorten(force_newton, allowed_force_newton(state.thermal, settings.thermal))) {
    limits |= bit(ForceLimit::Heat);
  }
}

}  // namespace

ForceOutputSettings force_output_settings(const DeviceLimits& limits,
                                          double simulated_spring_newton_per_mm,
                                          std::int32_t exchanges_until_sent) noexcept {
  CHECK(is_possible(limits) && simulated_spring_newton_per_mm > 0.0);
  ForceOutputSettings settings;
  settings.scale = force_scale_on(limits, simulated_spring_newton_per_mm);
  settings.force_newton = limits.force_newton;
  settings.slew_newton_per_s = limits.slew_newton_per_s;
  settings.passivity.spring_newton_per_mm = settings.scale * simulated_spring_newton_per_mm;
  settings.passivity.damping_newton_s_per_mm = limits.damping_newton_s_per_mm;
  settings.passivity.exchanges_until_sent =
      std::clamp(exchanges_until_sent, 0, exchanges_until_sent_at_most);
  settings.passivity.transport_ticks =
      std::clamp(limits.transport_ticks, 0, transport_ticks_at_most);
  settings.thermal = {limits.continuous_force_newton, limits.thermal_time_s};
  return settings;
}

DeviceForce output_force(ForceOutputState& state, const ForceOutputSettings& settings,
                         const ForceInput& input) noexcept {
  const double duration_s = std::isfinite(input.duration_s)
                                ? std::clamp(input.duration_s, shortest_tick_s, longest_tick_s)
                                : longest_tick_s;
  warm(state.thermal, settings.thermal, length_of(state.sent_newton), duration_s);
  const bool is_sane = is_finite(input.simulated_in_world_newton) &&
                       is_finite(input.handle_in_world_mm) &&
                       is_finite(input.vibration_in_world_newton);
  if (!input.is_live || !is_sane) return stop(state, ForceLimit::Stopped);
  const HandleMotion motion{
      state.has_handle ? input.handle_in_world_mm - state.handle_in_world_mm : Vec3(0.0, 0.0, 0.0),
      duration_s};
  if (!(length_of(motion.way_mm) <= settings.speed_limit_mm_s * duration_s)) {
    return stop(state, ForceLimit::TooFast);
  }
  state.handle_in_world_mm = input.handle_in_world_mm;
  state.has_handle = true;

  DeviceForce output;
  const Vec3 scaled_newton = settings.scale * input.simulated_in_world_newton;
  const Vec3 wanted_newton = started(state, settings, scaled_newton, duration_s, output.limits);
  Vec3 force_newton = kept_passive(state.account, settings.passivity, motion, wanted_newton);
  if (force_newton != wanted_newton) output.limits |= bit(ForceLimit::Passivity);
  const Vec3 vibration_newton = state.started_share * input.vibration_in_world_newton;
  force_newton += vibration_newton;
  limit(force_newton, state, settings, duration_s, output.limits);
  if (!is_finite(force_newton)) return stop(state, ForceLimit::Stopped);
  state.sent_newton = output.force_in_world_newton = force_newton;
  note_made(state.account, force_newton - vibration_newton);
  return output;
}

}  // namespace hallux::simulator
