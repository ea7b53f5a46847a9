/// What an attempt left, as everything that measures it needs it. Inside this room only.
#pragma once

#include <string>
#include <vector>

#include "assessment/rebuild/cut_face.h"
#include "assessment/rebuild/rebuild.h"
#include "scenarios/plan.h"
#include "scenarios/scenario.h"
#include "simulator/mesh/bones.h"
#include "simulator/record/tape_lines.h"

namespace hallux::assessment {

/// Borrowed for the call.
struct Evidence {
  const scenarios::Scenario& scenario;
  const scenarios::Plan& plan;
  const RebuiltBone& rebuilt;
  /// Per planned cut (see faces_of_cut).
  const std::vector<std::vector<CutFace>>& faces;
  simulator::Bones bones;
  /// Samples and events in the order of their ticks.
  const simulator::Recording& recording;
  /// Of that recording, in the order of ticks; none where only geometry is measured.
  simulator::TapeLines tape = {};

  simulator::Recorded recorded() const { return {recording, tape}; }
};

/// The mean over the planned cuts of how much of each was sawn.
inline double done_fraction_of(const std::vector<std::vector<CutFace>>& faces) {
  double sum = 0.0;
  for (const std::vector<CutFace>& cut : faces)
    sum += cut.empty() || cut.front().samples_in_bone_mm.empty() ? 0.0 : cut.front().done_fraction;
  return sum / static_cast<double>(faces.size());
}

/// The face of a cut that counts first; null where there is none with points.
inline const CutFace* counting_face(const Evidence& evidence, const std::string& cut) {
  const std::vector<CutFace>& faces = evidence.faces[index_of_cut(evidence.plan, cut)];
  return faces.empty() || faces.front().samples_in_bone_mm.empty() ? nullptr : &faces.front();
}

}  // namespace hallux::assessment
