/// Import of an exported attempt that was read: stored as a whole or not at all.
/// Inside this room only.
///
/// What was said of it where it was made (score cards, decisions) is believed of an origin that an
/// administrator accepted, and of no other: nothing proves it.
#pragma once

#include <optional>

#include "database/audit/audit.h"
#include "database/exchange/read_exported.h"
#include "database/records/score.h"
#include "database/store/connection.h"

namespace hallux::database {

/// Whether this very attempt is here already.
/// errors  DatabaseError BadInput where another one is here under its uuid
bool is_here(Database& database, const ImportedAttempt& attempt);

/// Stores it as of its origin: the score cards and decisions as they were there, then `rescored`,
/// what this program makes of it, as the score in force. One transaction.
/// needs   rescored is given where it is sealed
/// errors  DatabaseError: BadInput as is_here, and where it contradicts itself; Refused where its
///         person was erased here; storage failures
void store_imported(Database& database, const ImportedAttempt& attempt,
                    const std::optional<ScoreCard>& rescored, PersonId by);

/// errors  DatabaseError Damaged where the attempt that the audit row is about is not what was
///         imported
void check_imported(Database& database, const AuditEntry& entry);

}  // namespace hallux::database
