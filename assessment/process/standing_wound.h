/// The wound as samples are followed again in it: every fragment as it lies at that moment.
/// Inside this room only.
#pragma once

#include <deque>
#include <vector>

#include "simulator/contact/tissue.h"
#include "simulator/contact/wound.h"
#include "simulator/cutting/field/kerf_set.h"
#include "simulator/mesh/bones.h"

namespace hallux::assessment {

/// Of each of a patient's bones the tissue as it was, and how it lies to the first.
struct BoneTissues {
  explicit BoneTissues(const simulator::Bones& bones);

  std::deque<simulator::TissueMap> maps;
  std::vector<RigidTransform> first_from_bones;
};

/// Borrows both. A recording holds no bodies of pieces: bone that was picked up is still there, and
/// of a fragment that was parted the bone beyond its walls as well.
simulator::Wound standing_wound(const BoneTissues& tissues, const simulator::KerfSet& kerfs);

}  // namespace hallux::assessment
