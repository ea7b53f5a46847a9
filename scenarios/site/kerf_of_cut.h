/// The planned cut that a kerf lies nearest to.
#pragma once

#include <cstddef>

#include "scenarios/plan.h"
#include "simulator/cutting/field/kerf.h"

namespace hallux::scenarios {

/// How far a kerf's plane is from a planned face: a tilt of one degree counts as much as a
/// millimetre, since over a section of 20 mm they move the face by as much.
double misfit(const simulator::KerfPlane& plane, const PlannedCut& cut) noexcept;

/// Of the cuts of that bone, in whose frame the plane is, the one of least misfit; the earlier of
/// two alike. The number of cuts where that bone has none.
std::size_t nearest_cut(const simulator::KerfPlane& plane, const Plan& plan,
                        std::size_t bone = 0) noexcept;

}  // namespace hallux::scenarios
