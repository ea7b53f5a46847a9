/// Heat, danger zones and bend of an attempt, computed from its record alone.
#pragma once

#include <vector>

#include "simulator/mesh/bone.h"
#include "simulator/step/tool_effects.h"

namespace hallux::tests {

class RecordedEffects {
 public:
  /// Follows the whole record: the planes that were frozen, and each sample. Borrows `bone`.
  RecordedEffects(const simulator::Bone& bone, const simulator::Recording& recording,
                  const std::vector<simulator::DangerCapsule>& danger_zones = {},
                  bool is_guided = false);

  const simulator::ToolEffects& effects() const noexcept { return effects_; }
  const std::vector<simulator::CutEvent>& events() const noexcept { return events_; }
  std::vector<simulator::CutEvent> events(simulator::CutEventKind kind) const;

 private:
  simulator::TissueMap tissue_;
  simulator::KerfSet kerfs_;
  simulator::ToolEffects effects_;
  std::vector<simulator::CutEvent> events_;
};

}  // namespace hallux::tests
