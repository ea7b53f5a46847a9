#include "tests/simulator/device/wall_run.h"

#include <algorithm>

#include "simulator/base/units.h"
#include "simulator/device/modelled/tremor.h"

namespace hallux::tests {

using simulator::ArmState;
using simulator::ArmTraits;
using simulator::ForceOutputSettings;
using simulator::HandGrip;

WallLaw spring_wall(double stiffness_newton_per_mm) {
  return [=](double place_mm) { return -stiffness_newton_per_mm * std::max(0.0, place_mm); };
}

WallTrace press(const WallRun& run, const WallLaw& wall, const ForceOutputSettings* output) {
  const simulator::Tremor tremor(run.seed, run.tremor_mm);
  simulator::ForceOutputState state;
  state.started_share = 1.0;
  ArmState arm;
  arm.place_mm.x = run.start_mm;
  arm.velocity_mm_s.x = run.start_speed_mm_s;
  WallTrace trace;
  double wall_newton = 0.0;
  simulator::DeviceForce force;
  for (std::int64_t tick = 0; tick < run.ticks; ++tick) {
    const Vec3 read_mm = read_encoders(arm, run.arm);
    if (tick % run.ticks_per_update == 0) wall_newton = wall(read_mm.x);
    if (tick % run.ticks_per_line == 0) force = {{wall_newton, 0.0, 0.0}, 0};
    if (output != nullptr && tick % run.ticks_per_line == 0) {
      force = output_force(state, *output,
                           {.simulated_in_world_newton = force.force_in_world_newton,
                            .handle_in_world_mm = read_mm,
                            .duration_s = step_s * static_cast<double>(run.ticks_per_line)});
      trace.limits |= force.limits;
      trace.greatest_heat = std::max(trace.greatest_heat, state.thermal.heat);
    }
    send_force(arm, force.force_in_world_newton);
    HandGrip hand = run.hand;
    hand.wanted_mm += tremor.at(second_from_tick(tick));
    advance(arm, run.arm, hand);
    trace.place_mm.push_back(arm.place_mm.x);
    trace.force_newton.push_back(force.force_in_world_newton.x);
    trace.least_of_wall_millijoule =
        std::min(trace.least_of_wall_millijoule, -arm.work.of_motors_millijoule);
    trace.least_of_hand_millijoule =
        std::min(trace.least_of_hand_millijoule, arm.work.of_hand_millijoule);
  }
  return trace;
}

double mean_mm(const WallTrace& trace, std::size_t ticks) {
  double sum_mm = 0.0;
  for (std::size_t i = trace.place_mm.size() - ticks; i < trace.place_mm.size(); ++i) {
    sum_mm += trace.place_mm[i];
  }
  return sum_mm / static_cast<double>(ticks);
}

double range_mm(const WallTrace& trace, std::size_t ticks) {
  const auto begin = trace.place_mm.end() - static_cast<std::ptrdiff_t>(ticks);
  const auto [least, most] = std::minmax_element(begin, trace.place_mm.end());
  return *most - *least;
}

ForceOutputSettings output_for_wall(double stiffness_newton_per_mm, std::int32_t transport_ticks) {
  const simulator::DeviceLimits falcon{.force_newton = 8.0,
                                       .continuous_force_newton = 4.0,
                                       .stiffness_newton_per_mm = 3.0,
                                       .damping_newton_s_per_mm = 0.02,
                                       .transport_ticks = transport_ticks};
  ForceOutputSettings settings = force_output_settings(falcon, stiffness_newton_per_mm, 0);
  settings.scale = 1.0;
  settings.passivity.spring_newton_per_mm = stiffness_newton_per_mm;
  return settings;
}

namespace {

/// Whether a push of a millimetre dies away at a spring that never ends.
bool comes_to_rest(const ArmTraits& arm, const HandGrip& hand, double stiffness_newton_per_mm,
                   std::int64_t ticks_per_update) {
  WallRun run{.arm = arm, .hand = hand, .start_mm = 1.0, .ticks_per_update = ticks_per_update};
  run.arm.encoder_step_mm = 1.0e-9;
  run.arm.motor_limit_newton = 1.0e9;
  const WallTrace trace =
      press(run, [=](double place_mm) { return -stiffness_newton_per_mm * place_mm; });
  return range_mm(trace, 500) < 1.0;
}

}  // namespace

double stiffest_stable_wall(const ArmTraits& arm, const HandGrip& hand,
                            std::int64_t ticks_per_update) {
  double stable = 0.01, unstable = 40.0;
  while (unstable - stable > 0.002 * stable) {
    const double middle = 0.5 * (stable + unstable);
    (comes_to_rest(arm, hand, middle, ticks_per_update) ? stable : unstable) = middle;
  }
  return stable;
}

}  // namespace hallux::tests
