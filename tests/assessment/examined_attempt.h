/// Examined attempts, kept together with all that an examination borrows.
#pragma once

#include <string>
#include <vector>

#include "assessment/assess.h"
#include "tests/assessment/akin_attempt.h"
#include "tests/assessment/block_attempt.h"

namespace hallux::assessment::testing {

struct ExaminedAttempt {
  scenarios::Scenario scenario;
  simulator::Bone bone;
  /// May be altered after it was examined: what looks at samples and events alone sees it.
  simulator::Recording recording;
  Examination examination;

  Evidence evidence() const {
    return {scenario, examination.plan, examination.rebuilt,          examination.faces,
            bone,     recording,        simulator::tape_of(recording)};
  }
  /// Of a cut, a hinge, a zone or, with an empty name, of the attempt.
  /// needs   it is there
  const Measurement& found(const std::string& metric, const std::string& subject = "") const;
  /// needs   it is measured
  double value(const std::string& metric, const std::string& subject = "") const;
};

ExaminedAttempt examined(const scenarios::Scenario& scenario, const simulator::Bone& bone,
                         const simulator::Recording& recording);
/// On the block.
ExaminedAttempt examined(const scenarios::Scenario& scenario, const std::vector<Stroke>& strokes);
/// On the oval bone.
ExaminedAttempt examined(const scenarios::Scenario& scenario, const AkinAttempt& attempt);

/// The worked example with the steps that take its wedge out and close it.
scenarios::Scenario akin_with_deeds();

}  // namespace hallux::assessment::testing
