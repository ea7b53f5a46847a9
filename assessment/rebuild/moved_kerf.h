/// An attempt with one of its kerfs moved as a whole. Inside this room only.
#pragma once

#include <cstdint>

#include "assessment/rebuild/opened_fields.h"
#include "simulator/cutting/field/kerf_set.h"
#include "simulator/record/record.h"

namespace hallux::assessment {

/// `bone_from_moved` takes each point of the kerf to where it is to be.
struct KerfMove {
  std::int32_t kerf = -1;
  RigidTransform bone_from_moved;
};

/// What was sawn so far, as fields that rebuild takes in place of the samples.
OpenedFields kept_fields(const simulator::KerfSet& kerfs);

/// Moves the plane that the kerf was frozen to and the tool at each sample in it; poses are rounded
/// to their quanta, as recorded ones are. Where the blade was in no kerf stays.
/// needs   the recording has the kerf
void move_kerf(simulator::Recording& recording, OpenedFields& fields,
               const RigidTransform& world_from_bone, const KerfMove& move);

}  // namespace hallux::assessment
