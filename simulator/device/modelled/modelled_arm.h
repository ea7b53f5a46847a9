/// A haptic device that is computed: the arm's model, held by a hand that follows a motion as a
/// spring does.
///
/// It stands where a driver stands, so the whole loop is proved without hardware: force out,
/// transport, motors, mass, hand, encoders, state in. The hand wants to be where the motion is, and
/// trembles; where bone stops the handle, the way between them is the push. It turns as the hand
/// turns; the gimbal's converters flicker by a step or two.
#pragma once

#include "simulator/base/random.h"
#include "simulator/device/haptic_device.h"
#include "simulator/device/modelled/arm_model.h"
#include "simulator/device/modelled/tremor.h"
#include "simulator/device/scripted.h"

namespace hallux::simulator {

struct ModelledHand {
  double stiffness_newton_per_mm = 0.3;
  double damping_newton_s_per_mm = 0.003;
  /// Root mean square along each axis.
  double tremor_mm = 0.05;
};

struct ModelledArmSetup {
  ArmTraits arm = {};
  ModelledHand hand = {};
  DeviceLimits limits{.force_newton = 8.0,
                      .continuous_force_newton = 4.0,
                      .thermal_time_s = 10.0,
                      .stiffness_newton_per_mm = 3.0,
                      .damping_newton_s_per_mm = 0.02};
  std::uint64_t seed = 1;
};

class ModelledArm final : public HapticDevice {
 public:
  /// Never the same state for longer: the gimbal flickers among nine steps about each of three
  /// axes.
  static constexpr std::int64_t flicker_ticks = 2;

  /// At rest where the motion begins.
  /// needs   at least one key, ticks ascending
  ModelledArm(const HandMotion& motion, const ModelledArmSetup& setup);

  const ArmState& arm() const noexcept { return arm_; }

  DeviceDescription description() const override;
  bool exchange(const Vec3& force_in_world_newton, std::int64_t tick,
                RawDeviceState& state) noexcept override;

 private:
  Quat flickered(const Quat& rotation) noexcept;

  ModelledArmSetup setup_;
  ScriptedDevice wanted_;
  Tremor tremor_;
  Random gimbal_;
  ArmState arm_;
  /// Of the last exchange.
  std::int64_t tick_ = -1;
  std::uint64_t packet_ = 0;
};

}  // namespace hallux::simulator
