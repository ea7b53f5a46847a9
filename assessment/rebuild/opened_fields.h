/// A recording's kerfs as fields with the tick at which each node opened: what a replay is shown
/// from, and what the bone is rebuilt from without stamping once more.
#pragma once

#include <vector>

#include "simulator/base/progress.h"
#include "simulator/cutting/field/opened_field.h"
#include "simulator/mesh/bones.h"
#include "simulator/record/record.h"
#include "simulator/tool/tray.h"

namespace hallux::assessment {

/// One per kerf, in the order in which they were frozen.
using OpenedFields = std::vector<simulator::OpenedField>;

/// Follows the recording once.
/// needs   recording's samples and events are in the order of their ticks
/// errors  Cancelled
/// thread  any
OpenedFields opened_fields(const simulator::Tray& tray, const simulator::Bones& bones,
                           const simulator::Recording& recording, const Progress& progress = {});

/// Whether `fields` are of this recording's planes and kerfs: what was kept of another one is not
/// used.
bool are_of(const OpenedFields& fields, const simulator::Tray& tray, const simulator::Bones& bones,
            const simulator::Recording& recording);

}  // namespace hallux::assessment
