/// How far a thin blade bends out of its plane: a cantilever held in the collar, loaded where it
/// enters bone. Inside this room only.
///
/// A quantity to report; the tool's motion in a kerf has its own law (tool_motion.h).
/// source  docs/haptics.md, How far the blade bends
#pragma once

#include "simulator/contact/wound.h"

namespace hallux::simulator {

inline constexpr double steel_modulus_newton_per_mm2 = 200000.0;

struct BladeBeam {
  double free_length_mm = 0.0;
  double width_mm = 10.0;
  /// Of the steel, not of the kerf.
  double thickness_mm = 0.4;
};

/// Deflection of the loaded end, with the sign of the force: F L^3 / (3 E I), I = w t^3 / 12 [mm].
/// needs   width and thickness above 0
double deflection_mm(const BladeBeam& beam, double side_force_newton) noexcept;

/// How much of the blade stands out of the bone, from the collar forward to where its middle line
/// enters a fragment's outer surface as it was before its kerfs: the whole depth in air, 0 where
/// the collar is inside [mm].
/// thread  haptic; allocates nothing
double free_length_mm(const RigidTransform& bone_from_tool, double depth_mm,
                      const Wound& bone) noexcept;

}  // namespace hallux::simulator
