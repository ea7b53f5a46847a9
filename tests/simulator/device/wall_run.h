/// A modelled arm pressed against a wall, in virtual time: for the tests of what an arm is given,
/// and for their plots.
///
///     hand --push--> handle | wall: force of a law at x > 0, in newtons of the device
#pragma once

#include <functional>
#include <vector>

#include "simulator/device/force_output.h"
#include "simulator/device/modelled/arm_model.h"

namespace hallux::tests {

/// The force [N] along x on a handle at `place_mm`; called once in `ticks_per_update` ticks.
using WallLaw = std::function<double(double place_mm)>;

/// A spring that begins at 0 and pushes towards -x.
WallLaw spring_wall(double stiffness_newton_per_mm);

struct WallRun {
  simulator::ArmTraits arm;
  /// It wants to be at 0 and pushes besides, where nothing else is said.
  simulator::HandGrip hand;
  double start_mm = -2.0;
  double start_speed_mm_s = 0.0;
  double tremor_mm = 0.0;
  std::uint64_t seed = 1;
  std::int64_t ticks = 3000;
  /// Of the wall.
  std::int64_t ticks_per_update = 1;
  /// Of the loop that reads the handle and makes the force.
  std::int64_t ticks_per_line = 1;
};

struct WallTrace {
  /// Of the handle, a value a tick.
  std::vector<double> place_mm;
  /// Sent, along x.
  std::vector<double> force_newton;
  /// The least of what the hand had put in beyond what it got back, at any tick: below 0, it was
  /// given energy. Through the motors: wall and loop alone.
  double least_of_wall_millijoule = 0.0;
  /// Through the hand: arm and wall together.
  double least_of_hand_millijoule = 0.0;
  /// Bits of ForceLimit that occurred.
  std::uint32_t limits = 0;
  double greatest_heat = 0.0;
};

/// `output` null: the wall's force goes to the motors as it is.
WallTrace press(const WallRun& run, const WallLaw& wall,
                const simulator::ForceOutputSettings* output = nullptr);

/// Of the last `ticks` ticks.
double mean_mm(const WallTrace& trace, std::size_t ticks);
double range_mm(const WallTrace& trace, std::size_t ticks);

/// As a Falcon by its maker's figures, told device newtons: scale 1, however stiff the wall.
simulator::ForceOutputSettings output_for_wall(double stiffness_newton_per_mm,
                                               std::int32_t transport_ticks);

/// The stiffest spring [N/mm] on which the arm comes to rest, found by halving: no encoder steps,
/// no limit of the motors.
double stiffest_stable_wall(const simulator::ArmTraits& arm, const simulator::HandGrip& hand,
                            std::int64_t ticks_per_update = 1);

}  // namespace hallux::tests
