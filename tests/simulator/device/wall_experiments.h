/// Two experiments with a modelled arm, in virtual time: which walls are stable, and three force laws at a thin plate.
///
/// The plots of docs/haptics.md, the table of tests/benchmarks/haptics and the tests draw on the same runs.
#pragma once

#include <array>
#include <vector>

#include "tests/simulator/device/wall_run.h"

namespace hallux::tests {

inline constexpr std::size_t map_delays = 4;  ///< 0 to 3 ticks

/// A wall of that stiffness, met by a hand that pushes with 2 N from 2 mm before it.
struct StabilityCell {
  double stiffness_newton_per_mm = 0.0;
  /// How far the handle still goes to and fro in the last half of three seconds, without and with passivity controller.
  double plain_range_mm = 0.0, passive_range_mm = 0.0;
};

struct StabilityColumn {
  std::int32_t delay_ticks = 0;
  double theory_newton_per_mm = 0.0;  ///< b / (T / 2 + d T)
  double measured_newton_per_mm =
      0.0;  ///< the stiffest spring without end on which this arm comes to rest
  std::vector<StabilityCell> cells;  ///< ascending, each stiffer by the same factor
};

/// The device's share of the damping and the hand's, together b.
double damping_newton_s_per_mm();
std::array<StabilityColumn, map_delays> map_stability();

/// How a force is made of the place of a handle in a plate 5 mm thick, whose near face lies at 0.
enum class PlateLaw {
  Proxy,    ///< a spring to a proxy that stays on the face where the handle came in
  Penalty,  ///< a spring to the nearest face
  Historic  ///< the thesis's
};
inline constexpr double plate_mm = 5.0;
inline constexpr double plate_stiffness_newton_per_mm = 1.0;
inline constexpr double plate_push_newton = 2.0;

struct PlateResult {
  WallTrace trace;
  double deepest_mm = 0.0;
  double rest_mm = 0.0;             ///< mean of the last half second
  double range_mm = 0.0;            ///< to and fro in it
  int switches = 0;                 ///< how often the force went on, off or about
  double speed_mm_s = 0.0;          ///< the greatest in the last half second
  bool has_fallen_through = false;  ///< it was beyond the far face
};

/// Three seconds of a hand that pushes with 2 N; the law is asked every so many ticks.
PlateResult press_plate(PlateLaw law, std::int64_t ticks_per_update);

}  // namespace hallux::tests
