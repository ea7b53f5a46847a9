#include "simulator/device/thermal_budget.h"

#include <algorithm>
#include <cmath>

namespace hallux::simulator {

namespace {

/// In which the force sinks to what is continuous. Ours: slow enough not to be felt as a step.
constexpr double ease_s = 0.5;

}  // namespace

double allowed_force_newton(const ThermalBudget& budget, const ThermalSettings& settings) noexcept {
  const double cold = std::max(0.0, 1.0 - budget.heat);
  const double share = std::max(1.0, settings.thermal_time_s / ease_s);
  return settings.continuous_force_newton * std::sqrt(budget.heat + cold * share);
}

void warm(ThermalBudget& budget, const ThermalSettings& settings, double force_newton,
          double duration_s) noexcept {
  const double ratio = force_newton / settings.continuous_force_newton;
  const double share = std::min(1.0, duration_s / settings.thermal_time_s);
  budget.heat += share * (ratio * ratio - budget.heat);
}

}  // namespace hallux::simulator
