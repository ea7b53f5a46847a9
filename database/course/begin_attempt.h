/// The beginning of an attempt: who may begin it, its row, its lease and its line of the audit.
/// Inside this room only.
#pragma once

#include "database/records/attempt.h"
#include "database/store/connection.h"
#include "database/store/writer_lease.h"

namespace hallux::database {

/// Stores a new attempt in state recording and takes its lease: give it to a Recorder. Where the
/// lease goes away without a seal, the next opening for writing marks the attempt as interrupted.
/// A person's assessments are counted against the limits of their cohorts
/// (database/course/limits.h).
/// errors  DatabaseError: BadInput where the scenario version or the bone is not stored, or where a
///         person is named with a scripted hand outside a simulated course; Refused where no
///         assessment is left; storage failures
WriterLease create_attempt(Database& database, const NewAttempt& attempt);

}  // namespace hallux::database
