/// Erased recordings: the chunks and what was on the screen are gone; the facts, the seal and the
/// score of the attempt stay.
/// Inside this room only.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "database/records/ids.h"
#include "database/store/connection.h"
#include "simulator/base/digest.h"

namespace hallux::database {

struct ErasedRecording {
  /// Of its chain: with it the seal can still be checked.
  Digest last_link;
  std::int64_t windows = 0;
  std::string erased_utc;
};

/// Nothing where the recording of that attempt was not erased.
std::optional<ErasedRecording> erased_recording(Database& database, const AttemptId& id);

/// Takes the chunks of an attempt away, its display facts and the field that was kept of it, in one
/// transaction with its audit row. Once more does nothing. Returns the bytes that went.
/// errors  DatabaseError: NotFound; Refused while it is being recorded; storage failures
std::int64_t erase_recording(Database& database, const AttemptId& id,
                             std::optional<PersonId> actor);

}  // namespace hallux::database
