#include "simulator/device/modelled/arm_model.h"

#include <cmath>

#include "simulator/base/units.h"

namespace hallux::simulator {

namespace {

constexpr double mm_per_m = 1000.0;

}  // namespace

void send_force(ArmState& arm, const Vec3& force_newton) noexcept {
  for (std::size_t i = arm.sent_newton.size(); i-- > 1;) {
    arm.sent_newton[i] = arm.sent_newton[i - 1];
  }
  arm.sent_newton[0] = force_newton;
}

void advance(ArmState& arm, const ArmTraits& traits, const HandGrip& hand) noexcept {
  const double substep_s = step_s / static_cast<double>(traits.substeps);
  const Vec3 motors_newton = shortened(
      arm.sent_newton[static_cast<std::size_t>(traits.transport_ticks)], traits.motor_limit_newton);
  for (std::int32_t i = 0; i < traits.substeps; ++i) {
    const Vec3 hand_newton = hand.stiffness_newton_per_mm * (hand.wanted_mm - arm.place_mm) -
                             hand.damping_newton_s_per_mm * arm.velocity_mm_s + hand.push_newton;
    const Vec3 sum_newton =
        motors_newton + hand_newton - traits.damping_newton_s_per_mm * arm.velocity_mm_s;
    arm.velocity_mm_s += substep_s * mm_per_m / traits.mass_kg * sum_newton;
    const Vec3 way_mm = substep_s * arm.velocity_mm_s;
    arm.place_mm += way_mm;
    arm.work.of_motors_millijoule += glm::dot(motors_newton, way_mm);
    arm.work.of_hand_millijoule += glm::dot(hand_newton, way_mm);
  }
}

Vec3 read_encoders(const ArmState& arm, const ArmTraits& traits) noexcept {
  const auto whole = [&](double mm) {
    return traits.encoder_step_mm * std::floor(mm / traits.encoder_step_mm + 0.5);
  };
  return {whole(arm.place_mm.x), whole(arm.place_mm.y), whole(arm.place_mm.z)};
}

}  // namespace hallux::simulator
