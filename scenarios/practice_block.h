/// A block to learn the saw on: a bar with one planned cut across it, two passes wide. It is
/// nobody's bone, is in no list, and nothing done to it is scored.
#pragma once

#include "scenarios/scenario.h"
#include "simulator/mesh/bone.h"

namespace hallux::scenarios {

struct PracticeBlock {
  /// Without a rubric: look, saw, take out.
  Scenario scenario;
  simulator::Bone bone;
};

/// ensures the same block each time
PracticeBlock make_practice_block();

}  // namespace hallux::scenarios
