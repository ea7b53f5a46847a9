/// Attempts: listed, found, sealed. They begin in database/course/begin_attempt.h; their recordings
/// are written by database/recording/recorder.h and read by database/recording/recordings.h.
/// Inside this room only.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "database/records/attempt.h"
#include "database/records/person.h"
#include "database/store/connection.h"

namespace hallux::database {

/// Whose attempts a list holds.
struct AttemptFilter {
  /// Of this person.
  std::optional<PersonId> person;
  /// Of the trainees of this cohort.
  std::optional<CohortId> cohort;
  /// The robot's; alone or together with one of the others.
  bool of_nobody = false;
  /// At most so many, the newest.
  std::optional<std::int32_t> count_max;
};

/// Newest first; all where the filter asks for nothing.
std::vector<AttemptHeader> list_attempts(Database& database, const AttemptFilter& filter = {});

/// `id` may be shortened to at least 4 characters where only one attempt begins with them.
/// errors  DatabaseError NotFound naming the id
AttemptHeader load_header(Database& database, const AttemptId& id);

/// All whose uuid is `id` or begins with it; none where it is no beginning of a uuid.
std::vector<AttemptHeader> headers_that_begin_with(Database& database, const AttemptId& id);
/// The only one that was found.
/// errors  DatabaseError NotFound where there is none, or more than one
AttemptHeader the_one_of(Database& database, std::vector<AttemptHeader> found, const AttemptId& id);

/// Closes an attempt: state, duration, quality and seal, whether it is valid by that quality, with
/// an audit row that holds the seal.
/// needs   the writer of the attempt has committed its last window; `last_link` is the link of that
/// errors  DatabaseError: NotFound where it is not in state recording
void seal_attempt(Database& database, const AttemptId& id, std::int64_t duration_ticks,
                  const std::string& quality_json, const Digest& last_link);

/// Marks an attempt as interrupted because its person gave it up, with an act of theirs.
/// needs   the writer of the attempt has committed its last window
/// errors  DatabaseError: NotFound where it is not in state recording
void abandon_attempt(Database& database, const AttemptId& id);

}  // namespace hallux::database
