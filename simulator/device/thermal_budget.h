/// The I2t budget of a device's motors: their heat follows the square of the force, and what they
/// may give follows the heat. Inside this corner only.
///
///     dh/dt = ((F / Fc)^2 - h) / tau        h = 1: as warm as the continuous force Fc makes them
///                                           in the end
///     F <= Fc sqrt(h + (1 - h) tau / ease)  so h never passes 1, and the force sinks over `ease`
///                                           instead of falling
#pragma once

namespace hallux::simulator {

struct ThermalSettings {
  double continuous_force_newton = 1.0;
  double thermal_time_s = 10.0;
};

struct ThermalBudget {
  /// 0 cold, 1 as warm as allowed.
  double heat = 0.0;
};

/// The greatest force [N] that keeps the heat at or below 1.
double allowed_force_newton(const ThermalBudget& budget, const ThermalSettings& settings) noexcept;

/// Warms or cools the motors for a time in which that force acted.
/// needs   0 <= duration_s <= 0.003
void warm(ThermalBudget& budget, const ThermalSettings& settings, double force_newton,
          double duration_s) noexcept;

}  // namespace hallux::simulator
