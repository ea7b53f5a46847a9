/// How far a metric may be from its exact value: what its bound is made of. Inside this room only.
///
/// A bound is of grids and steps: the kerfs' field, the points of a face, rows, ticks, and the
/// rounding of the value itself. What was recorded is taken as exact. Whether something counts at
/// all (a stretch that is long enough, a row of the bridge, a ledge) is decided on the grid, and
/// the bound holds for what counts.
/// source  docs/metrics.md, "How sure"
#pragma once

#include "scenarios/metric_names.h"
#include "simulator/base/units.h"
#include "simulator/cutting/field/kerf.h"

namespace hallux::assessment {

/// Of a value that is rounded to 1e-6 of its unit.
inline constexpr double rounding_bound = 0.5e-6;

/// Of a square with sides of 1.
inline constexpr double diagonal = 1.4142135623730951;

/// From the point of a face that lies furthest to one side to the nearest sample, in steps of the
/// grid: a disc that holds a sample in any place has a radius of half a diagonal, and in a corner
/// of 90 degrees its farthest point lies 1.71 steps away.
inline constexpr double reach_steps = 2.0;

/// Of the border of what a blade opened: the outline crosses the same cells of the field, and is
/// straightened by less than a fiftieth of one.
inline constexpr double field_bound_mm = (diagonal + 0.02) * simulator::FieldGrid{}.spacing_mm;

/// Of the normal of a face: the points of a wall lie in one plane but for 1e-9 mm, and spread over
/// 0.05 mm at least, which makes 2e-8 of each of two of them.
inline constexpr double normal_bound_rad = 1.0e-7;
/// Of a face where the plan asks for it, up to 100 mm from its points.
inline constexpr double plane_bound_mm = 100.0 * normal_bound_rad;

}  // namespace hallux::assessment
