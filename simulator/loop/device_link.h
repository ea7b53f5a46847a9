/// The loop's end of a device: reads and judges what it says, and makes of the simulated force what
/// it is given. Inside this corner only.
///
///     device --state--> watchdog --> line of the tape --> step --> sample --> force output
///        ^                                                                         |
///        '---------------- force, with the next exchange: one tick later ----------'
///
/// A device without limits pushes nobody back: it is told the simulated force as it is.
#pragma once

#include <cstdint>
#include <optional>

#include "simulator/contact/vibration.h"
#include "simulator/device/force_output.h"
#include "simulator/device/haptic_device.h"
#include "simulator/device/thesis_law.h"
#include "simulator/loop/watchdog.h"
#include "simulator/record/record.h"
#include "simulator/step/simulation.h"

namespace hallux::simulator {

/// What an arm is made to feel. Neither changes what is simulated, recorded and scored.
enum class ForceLaw {
  /// The scaled force of the simulation.
  Simulated,
  /// The thesis's law where teeth touch bone: for the lesson.
  Thesis
};

class DeviceLink {
 public:
  /// Borrows the device for its lifetime. The contact's force is a spring of at most the coupling's
  /// stiffness.
  DeviceLink(HapticDevice& device, const SimulationSetup& simulated,
             ForceLaw law = ForceLaw::Simulated);
  ~DeviceLink() { release(); }
  DeviceLink(const DeviceLink&) = delete;
  DeviceLink& operator=(const DeviceLink&) = delete;

  /// One exchange: the force made last goes out, the judged state at `last_tick` of a line of
  /// `ticks` comes in.
  /// thread  haptic; allocates nothing
  DeviceState read(std::int64_t last_tick, std::int64_t ticks) noexcept;
  /// Makes the force for the next exchange of what the step has computed of that state.
  void set_force(const StepOutput& output, std::int64_t ticks) noexcept;
  /// No force from now on, said to the device at once where it has motors; what is given later
  /// begins softly.
  void release() noexcept;

  const Vec3& force_newton() const noexcept { return force_.force_in_world_newton; }
  /// Bits of ForceLimit.
  std::uint32_t limits() const noexcept { return force_.limits; }
  /// It pushes a hand.
  bool has_motors() const noexcept { return settings_.has_value(); }
  /// Another leads since then, whom nothing pushes.
  bool is_handed_over() const noexcept { return is_handed_over_; }
  /// Device newtons per simulated newton; 1 without limits.
  double scale() const noexcept { return settings_ ? settings_->scale : 1.0; }

 private:
  void be_handed_over() noexcept;
  /// What the thesis's law makes of the handle's motion at the surface that the simulated force
  /// comes from, in newtons of the simulation: the output scales them.
  Vec3 thesis_law_newton(const Vec3& simulated_newton, bool is_touching,
                         std::int64_t ticks) noexcept;

  /// How the running saw trembles along its teeth, for an arm that can render it; newtons of the
  /// device.
  Vec3 vibration_newton(const StepOutput& output, double push_newton, double duration_s,
                        bool is_live) noexcept;

  /// Where the handle is, in the millimetres of the hand: stiffness, speed and energy are felt
  /// there.
  Vec3 handle_in_hand_mm() const noexcept {
    return watchdog_.last_good().translation_mm / motion_scale_;
  }

  HapticDevice& device_;
  double motion_scale_;
  Tray tray_;
  double bone_quality_;
  ForceLaw law_;
  /// 0: the device renders none.
  double vibration_scale_;
  VibrationState vibration_;
  ThesisLawState thesis_law_;
  std::optional<ForceOutputSettings> settings_;
  DeviceWatchdog watchdog_;
  ForceOutputState output_;
  DeviceForce force_;
  std::int64_t last_tick_ = 0;
  bool is_handed_over_ = false;
};

}  // namespace hallux::simulator
