/// Display facts of attempts: what was on the screen, beside the recording. Inside this room only.
///
/// No digest is of them, so that what is read back may be anything that another tool wrote:
/// simulator::is_view says whether it is a view.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "database/records/ids.h"
#include "database/store/connection.h"
#include "simulator/record/display_fact.h"

namespace hallux::database {

/// By tick; none where nothing was shown, or what was has gone with the recording.
/// errors  DatabaseError
std::vector<simulator::DisplayFact> load_display_facts(Database& database, const AttemptId& id);

/// Stores them with the attempt of that row; of two with one tick the later stands.
/// needs   the caller's transaction
void store_display_facts(Database& database, std::int64_t attempt_number,
                         std::span<const simulator::DisplayFact> facts);

/// needs   the caller's transaction
void erase_display_facts(Database& database, std::int64_t attempt_number);

}  // namespace hallux::database
