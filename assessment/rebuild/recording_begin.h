/// The beginning of a recording, for questions about how bone was before more of it was sawn.
/// Inside this corner only.
#pragma once

#include <cstdint>

#include "simulator/record/record.h"

namespace hallux::assessment {

/// Its samples and events up to a tick and of it.
simulator::Recording begin_of(const simulator::Recording& recording, std::int64_t last_tick);

/// Whether a saw ran in a kerf after the first tick, and until the last one.
bool is_sawn_between(const simulator::Recording& recording, std::int64_t after_tick,
                     std::int64_t last_tick) noexcept;

}  // namespace hallux::assessment
