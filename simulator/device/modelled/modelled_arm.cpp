#include "simulator/device/modelled/modelled_arm.h"

#include <algorithm>

#include "simulator/base/check.h"
#include "simulator/base/units.h"

namespace hallux::simulator {

namespace {

/// A device that was not asked for longer goes on from where it was.
constexpr std::int64_t ticks_at_most = 3;
/// Of a converter of 16 bits over half a turn.
constexpr double gimbal_step_rad = 5.0e-5;
constexpr std::uint64_t gimbal_steps = 9;

Vec3 start_of(const HandMotion& motion) {
  CHECK(!motion.keys.empty());
  return motion.keys.front().world_from_handle.translation_mm;
}

}  // namespace

ModelledArm::ModelledArm(const HandMotion& motion, const ModelledArmSetup& setup)
    : setup_(setup),
      wanted_(motion),
      tremor_(setup.seed, setup.hand.tremor_mm),
      gimbal_(setup.seed, "arm.gimbal") {
  CHECK(setup.arm.transport_ticks >= 0 && setup.arm.transport_ticks <= transport_ticks_at_most);
  setup_.limits.transport_ticks = setup.arm.transport_ticks;
  arm_.place_mm = start_of(motion) + tremor_.at(0.0);
}

DeviceDescription ModelledArm::description() const {
  return {.name = "Modelled arm",
          .device_class = "arm",
          .limits = setup_.limits,
          .pulse = {.flicker_ticks = flicker_ticks, .numbers_packets = true}};
}

bool ModelledArm::exchange(const Vec3& force_in_world_newton, std::int64_t tick,
                           RawDeviceState& state) noexcept {
  RawDeviceState wanted;
  wanted_.exchange({0.0, 0.0, 0.0}, tick, wanted);
  const std::int64_t ticks =
      tick_ < 0 ? 0 : std::clamp<std::int64_t>(tick - tick_, 0, ticks_at_most);
  tick_ = tick;
  const HandGrip grip{setup_.hand.stiffness_newton_per_mm,
                      setup_.hand.damping_newton_s_per_mm,
                      wanted.world_from_handle.translation_mm + tremor_.at(second_from_tick(tick)),
                      {0.0, 0.0, 0.0}};
  for (std::int64_t i = 0; i < ticks; ++i) {
    // Transport goes on with the ticks, also of a line that covers several.
    if (i > 0) send_force(arm_, arm_.sent_newton[0]);
    advance(arm_, setup_.arm, grip);
  }
  send_force(arm_, force_in_world_newton);
  state.world_from_handle = {flickered(wanted.world_from_handle.rotation),
                             read_encoders(arm_, setup_.arm)};
  state.switches = wanted.switches;
  state.packet = ++packet_;
  return true;
}

Quat ModelledArm::flickered(const Quat& rotation) noexcept {
  const auto half_angle_rad = [&] {
    return 0.5 * gimbal_step_rad *
           (static_cast<double>(gimbal_.bits() % gimbal_steps) -
            0.5 * static_cast<double>(gimbal_steps - 1));
  };
  const double x = half_angle_rad(), y = half_angle_rad(), z = half_angle_rad();
  return normalised(rotation * Quat(1.0, x, y, z));
}

}  // namespace hallux::simulator
