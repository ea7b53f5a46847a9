/// What attempts measured, kept so that a score by other knots, weights or gates rebuilds nothing.
/// Only added to. Inside this room only.
///
///     recording (its seal) + plan + version of the metrics  -->  set: digest  -->  its rows
///                                                                  ^
///                                                    act `measurements_stored` of the audit
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "database/records/ids.h"
#include "database/records/measurement.h"
#include "database/store/connection.h"

namespace hallux::database {

/// What a set of measurements is of.
struct MeasurementKey {
  AttemptId attempt;
  Digest seal;
  MeasuredBy by;
};

/// The measurements of that recording; nothing where there are none of that plan and version, where
/// the attempt is not sealed, or where rows are not those that were stored: the recording is there
/// to measure again, and `verify` names what was altered.
/// errors  DatabaseError: NotFound; storage failures
std::optional<std::vector<Measurement>> load_measurements(Database& database,
                                                          const AttemptId& attempt,
                                                          const MeasuredBy& by);

/// Stores them with an audit row of `actor` (nobody: the house) that holds their digest. Those that
/// are there already, those of an attempt that is not sealed, and those with a number that is none
/// are not stored.
/// needs   they were computed from the recording
/// errors  DatabaseError: NotFound; storage failures
void store_measurements(Database& database, const AttemptId& attempt, const MeasuredBy& by,
                        std::span<const Measurement> measurements, std::optional<PersonId> actor);

/// What the audit keeps of a set: of what it is of, and of its rows in their order.
Digest measurements_digest(const MeasurementKey& key, std::span<const Measurement> measurements);

/// The rows of a set in their order; a row that cannot be read is refused.
/// errors  DatabaseError Damaged; storage failures
std::vector<Measurement> load_measurement_rows(Database& database, std::int64_t set_number);

}  // namespace hallux::database
