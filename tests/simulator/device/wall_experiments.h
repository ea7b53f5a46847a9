/// Two experiments with a modelled arm, in virtual time: which walls are stable, and three force
/// laws at a thin plate.
///
/// The plots of docs/haptics.md, the table of tests/benchmarks/haptics and the tests draw on the
/// same runs.
#pragma once

#include <array>
#include <vector>

#include "tests/simulator/device/wall_run.h"

namespace hallux::tests {

/// 0 to 3 ticks.
inline constexpr std::size_t map_delays = 4;

/// A wall of that stiffness, met by a hand that pushes with 2 N from 2 mm before it.
struct StabilityCell {
  double stiffness_newton_per_mm = 0.0;
  /// How far the handle still goes to and fro in the last half of three seconds, without and with
  /// passivity controller.
  double plain_range_mm = 0.0, passive_range_mm = 0.0;
};

struct StabilityColumn {
  std::int32_t delay_ticks = 0;
  /// b / (T / 2 + d T).
  double theory_newton_per_mm = 0.0;
  /// The stiffest spring without end on which this arm comes to rest.
  double measured_newton_per_mm = 0.0;
  /// Ascending, each stiffer by the same factor.
  std::vector<StabilityCell> cells;
};

/// The device's share of the damping and the hand's, together b.
double damping_newton_s_per_mm();
std::array<StabilityColumn, map_delays> map_stability();

/// How a force is made of the place of a handle in a plate 5 mm thick, whose near face lies at 0.
enum class PlateLaw {
  /// A spring to a proxy that stays on the face where the handle came in.
  Proxy,
  /// A spring to the nearest face.
  Penalty,
  /// The thesis's.
  Thesis
};
inline constexpr double plate_mm = 5.0;
inline constexpr double plate_stiffness_newton_per_mm = 1.0;
inline constexpr double plate_push_newton = 2.0;

struct PlateResult {
  WallTrace trace;
  double deepest_mm = 0.0;
  /// Mean of the last half second.
  double rest_mm = 0.0;
  /// To and fro in it.
  double range_mm = 0.0;
  /// How often the force went on, off or about.
  int switches = 0;
  /// The greatest in the last half second.
  double speed_mm_s = 0.0;
  /// It was beyond the far face.
  bool has_fallen_through = false;
};

/// Three seconds of a hand that pushes with 2 N; the law is asked every so many ticks.
PlateResult press_plate(PlateLaw law, std::int64_t ticks_per_update);

}  // namespace hallux::tests
