/// An examined attempt on the block, kept together with all that it borrows.
#pragma once

#include <utility>
#include <vector>

#include "assessment/assess.h"
#include "tests/assessment/block_attempt.h"

namespace hallux::assessment::testing {

struct BlockEvidence {
  scenarios::Scenario scenario;
  simulator::Bone bone = block_bone();
  /// May be altered after it was examined: what looks at the samples alone sees it.
  simulator::Recording recording;
  Examination examination;

  Evidence evidence() const noexcept {
    return {scenario, examination.plan, examination.rebuilt, examination.faces, bone, recording};
  }
};

inline BlockEvidence examined(const scenarios::Scenario& scenario,
                              const std::vector<Stroke>& strokes) {
  const simulator::Bone bone = block_bone();
  simulator::Recording recording;
  for (const Stroke& stroke : strokes) add_stroke(recording, bone, stroke);
  Examination examination = assess_fully(scenario, bone, recording, "scripted");
  return {scenario, bone, std::move(recording), std::move(examination)};
}

}  // namespace hallux::assessment::testing
