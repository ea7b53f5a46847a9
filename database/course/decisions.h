/// Decisions of instructors about results: confirmed, overridden or voided, each with a reason.
/// Inside this room only.
#pragma once

#include <vector>

#include "database/audit/audit.h"
#include "database/records/decision.h"
#include "database/store/connection.h"

namespace hallux::database {

/// Takes the place of the decision in force. A void sets the attempt's state; a later confirmation
/// or override sets it back. The audit row holds decision, attempt, score and points as numbers,
/// and the salted digest of the reason.
/// errors  DatabaseError: NotFound; BadInput where the reason is empty, the attempt is still being
///         recorded, or, unless it is voided, was interrupted or has no score
DecisionId decide(Database& database, const NewDecision& decision, PersonId by);

/// Newest first; the one in force, if any, is the first.
std::vector<Decision> load_decisions(Database& database, const AttemptId& attempt);

/// errors  DatabaseError Damaged where the decision that the audit row is about was altered
void check_decision(Database& database, const AuditEntry& entry);

/// errors  DatabaseError Damaged where a decision has no audit row, is in force though a later one
///         is there, or does not fit the state of its attempt
void check_decisions_are_whole(Database& database);

}  // namespace hallux::database
