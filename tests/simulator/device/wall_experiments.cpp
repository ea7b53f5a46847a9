#include "tests/simulator/device/wall_experiments.h"

#include <algorithm>
#include <cmath>

#include "simulator/base/elementary.h"
#include "simulator/base/units.h"
#include "simulator/device/thesis_law.h"

namespace hallux::tests {

using simulator::ArmTraits;
using simulator::ForceOutputSettings;
using simulator::HandGrip;

namespace {

/// From 0.25 to 16 N/mm, four to the octave.
constexpr int cells_per_octave = 4, octaves = 6;
constexpr double softest_newton_per_mm = 0.25;
constexpr std::size_t last_ticks = 500;

WallRun pushed(std::int32_t transport_ticks, double push_newton) {
  WallRun run;
  run.arm.transport_ticks = transport_ticks;
  run.hand.push_newton.x = push_newton;
  return run;
}

StabilityCell cell_at(double stiffness_newton_per_mm, std::int32_t delay_ticks) {
  const WallRun run = pushed(delay_ticks, 2.0);
  const WallLaw wall = spring_wall(stiffness_newton_per_mm);
  const ForceOutputSettings passive = output_for_wall(stiffness_newton_per_mm, delay_ticks);
  ForceOutputSettings plain = passive;
  plain.passivity.is_on = false;
  return {stiffness_newton_per_mm, range_mm(press(run, wall, &plain), last_ticks),
          range_mm(press(run, wall, &passive), last_ticks)};
}

WallLaw penalty() {
  return [](double place_mm) {
    if (place_mm <= 0.0 || place_mm >= plate_mm) return 0.0;
    const double to_face_mm = place_mm < 0.5 * plate_mm ? -place_mm : plate_mm - place_mm;
    return plate_stiffness_newton_per_mm * to_face_mm;
  };
}

WallLaw historic(std::int64_t ticks_per_update) {
  return [state = simulator::ThesisLawState{}, ticks_per_update](double place_mm) mutable {
    std::optional<Vec3> normal;
    if (place_mm >= 0.0 && place_mm <= plate_mm) normal = Vec3(-1.0, 0.0, 0.0);
    const simulator::ThesisLawSettings settings{.frame_ticks = ticks_per_update};
    return thesis_law_force(state, settings, {place_mm, 0.0, 0.0}, normal, ticks_per_update).x;
  };
}

WallLaw law_of(PlateLaw law, std::int64_t ticks_per_update) {
  if (law == PlateLaw::Penalty) return penalty();
  if (law == PlateLaw::Thesis) return historic(ticks_per_update);
  return spring_wall(plate_stiffness_newton_per_mm);
}

int sign_of(double value) { return (value > 0.0 ? 1 : 0) - (value < 0.0 ? 1 : 0); }

int count_switches(const std::vector<double>& force_newton) {
  int switches = 0;
  for (std::size_t i = 1; i < force_newton.size(); ++i) {
    if (sign_of(force_newton[i]) != sign_of(force_newton[i - 1])) ++switches;
  }
  return switches;
}

double fastest_mm_s(const std::vector<double>& place_mm) {
  double fastest = 0.0;
  for (std::size_t i = place_mm.size() - last_ticks; i < place_mm.size(); ++i) {
    fastest = std::max(fastest, std::abs(place_mm[i] - place_mm[i - 1]) / step_s);
  }
  return fastest;
}

}  // namespace

double damping_newton_s_per_mm() {
  return ArmTraits{}.damping_newton_s_per_mm + HandGrip{}.damping_newton_s_per_mm;
}

std::array<StabilityColumn, map_delays> map_stability() {
  std::array<StabilityColumn, map_delays> columns;
  const double factor = elementary::exp(elementary::log(2.0) / cells_per_octave);
  for (std::size_t i = 0; i < columns.size(); ++i) {
    StabilityColumn& column = columns[i];
    column.delay_ticks = static_cast<std::int32_t>(i);
    column.theory_newton_per_mm =
        damping_newton_s_per_mm() / (step_s * (0.5 + static_cast<double>(i)));
    column.measured_newton_per_mm =
        stiffest_stable_wall({.transport_ticks = column.delay_ticks}, HandGrip{});
    double stiffness_newton_per_mm = softest_newton_per_mm;
    for (int cell = 0; cell <= cells_per_octave * octaves; ++cell) {
      column.cells.push_back(cell_at(stiffness_newton_per_mm, column.delay_ticks));
      stiffness_newton_per_mm *= factor;
    }
  }
  return columns;
}

PlateResult press_plate(PlateLaw law, std::int64_t ticks_per_update) {
  WallRun run = pushed(1, plate_push_newton);
  run.start_mm = -1.0;
  run.ticks_per_update = ticks_per_update;
  PlateResult result;
  result.trace = press(run, law_of(law, ticks_per_update));
  const std::vector<double>& place_mm = result.trace.place_mm;
  result.deepest_mm = *std::max_element(place_mm.begin(), place_mm.end());
  result.rest_mm = mean_mm(result.trace, last_ticks);
  result.range_mm = range_mm(result.trace, last_ticks);
  result.switches = count_switches(result.trace.force_newton);
  result.speed_mm_s = fastest_mm_s(place_mm);
  // A proxy holds a handle that is beyond the far face; a spring to the nearest face lets go there.
  result.has_fallen_through = law != PlateLaw::Proxy && result.deepest_mm > plate_mm;
  return result;
}

}  // namespace hallux::tests
