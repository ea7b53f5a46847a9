/// Recordings read back, their chain checked link by link.
#pragma once

#include <cstdint>

#include "database/records/attempt.h"
#include "database/store/connection.h"
#include "simulator/record/record.h"

namespace hallux::database {

/// All that was committed: of a closed attempt the whole, of an interrupted one up to its last
/// window.
/// errors  DatabaseError: NotFound, also where the recording was erased; Damaged naming the first
///         chunk whose bytes or link were altered, or the seal
simulator::Recording load_recording(Database& database, const AttemptId& id);

/// What load_recording does, but keeps no rows longer than some windows; returns the number of
/// chunks. Of an erased one the seal is checked.
/// errors  as load_recording
std::int64_t check_recording(Database& database, const AttemptId& id);

}  // namespace hallux::database
