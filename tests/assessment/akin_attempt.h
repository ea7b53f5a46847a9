/// A stand-in for a phalanx with Akin's landmarks, and attempts to saw a wedge from it: the worked
/// example's bone.
#pragma once

#include <vector>

#include "scenarios/scenario.h"
#include "simulator/mesh/bone.h"
#include "simulator/record/record.h"

namespace hallux::assessment::testing {

/// An elliptic prism: x 0 to 27, y +-6.25 (dorsal), z +-7.5 (lateral).
simulator::Bone oval_bone();
/// The worked example: cut 1 at x = 6, wedge 10 degrees, hinge 1 mm inside z = 7.5; items A1 to A7,
/// the over-cut, and gates for the lost hinge and the plunge.
scenarios::Scenario akin_scenario(double kerf_mm = 0.5);

/// Tilts: transverse (positive: medial edge distal), sagittal (positive: plantar edge distal). The
/// finished faces meet at z = apex; both blades stop with their teeth at z = reach.
struct AkinAttempt {
  double entry_x_mm = 6.0, transverse_deg = 0.0, sagittal1_deg = 0.0;
  double wedge_deg = 10.0, sagittal2_deg = 0.0;
  double apex_mm = 6.5, reach1_mm = 6.5, reach2_mm = 6.5;
  bool is_second_first = false;
  bool has_second = true;
};

/// Blades come from medial, teeth along the face, 0.05 mm a tick, with a push of 9 N.
simulator::Recording akin_recording(const AkinAttempt& attempt, const simulator::Bone& bone,
                                    double kerf_mm = 0.5);

}  // namespace hallux::assessment::testing
