/// What waits in the rings of an attempt, moved into a recording in memory.
#pragma once

#include "simulator/record/channels.h"

namespace hallux::simulator {

/// True where there was anything.
/// thread  the consumer's
bool drain(AttemptChannels& channels, Recording& recording);

}  // namespace hallux::simulator
