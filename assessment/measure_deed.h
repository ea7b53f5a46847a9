/// The deeds that an operation asks for besides its cuts: a piece that is out, a wedge that is
/// closed. Inside this corner only.
#pragma once

#include <vector>

#include "assessment/measurement.h"
#include "assessment/rebuild/cut_face.h"
#include "scenarios/plan.h"
#include "scenarios/scenario.h"

namespace hallux::assessment {

/// What an attempt left, as the deeds need it; borrowed for the call.
struct DeedEvidence {
  const scenarios::Plan& plan;
  const RebuiltBone& rebuilt;
  /// Per planned cut (see faces_of_cut).
  const std::vector<std::vector<CutFace>>& faces;
  const simulator::Bone& bone;
  const simulator::Recording& recording;
};

/// piece_out for each step that removes, wedge_closed for each that closes, in the order of the
/// steps: 1 where it was done, 0 where not, always measured. A piece is out where most of the bone
/// beyond the measured face (of a wedge: between its two faces) was free and taken out.
/// errors  Cancelled
/// thread  any
std::vector<Measurement> measure_deeds(const scenarios::Scenario& scenario,
                                       const DeedEvidence& evidence, const Progress& progress = {});

}  // namespace hallux::assessment
