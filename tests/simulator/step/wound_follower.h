/// Heat, danger zones and bend of an attempt, computed from its record alone.
#pragma once

#include <vector>

#include "simulator/mesh/bone.h"
#include "simulator/step/wound.h"

namespace hallux::tests {

class WoundFollower {
 public:
  /// Follows the whole record: the planes that were frozen, and each sample. Borrows `bone`.
  WoundFollower(const simulator::Bone& bone, const simulator::Recording& recording,
                const simulator::WoundSettings& settings = {}, bool is_guided = false);

  const simulator::Wound& wound() const noexcept { return wound_; }
  const std::vector<simulator::CutEvent>& events() const noexcept { return events_; }
  std::vector<simulator::CutEvent> events(simulator::CutEventKind kind) const;

 private:
  simulator::TissueMap tissue_;
  simulator::KerfSet kerfs_;
  simulator::Wound wound_;
  std::vector<simulator::CutEvent> events_;
};

}  // namespace hallux::tests
