/// Scores kept attempts anew: by the assessment of this program, with the text each was operated
/// under or with that of another version. The old scores stay, and decisions stay about the score
/// they were about.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "simulator/base/progress.h"
#include "ui/jobs/attempt_jobs.h"

namespace hallux::ui {

/// A version that whoever scores may read: of the catalogue, or published.
struct KnownVersion {
  std::string scenario_name;
  std::int32_t version = 0;
  database::ScenarioVersionId id;
};

struct Rescoring {
  std::string scenario_name;
  /// Whose text scores; nothing: that of each attempt.
  std::optional<std::int32_t> version;
  /// Nothing is stored.
  bool is_dry_run = false;
  /// Beside those that the attempts were operated under; the later before the earlier.
  std::vector<KnownVersion> versions = {};
};

struct RescoredAttempt {
  /// As it was before.
  database::AttemptHeader header;
  std::optional<database::ScoreCard> before, after;
  /// The scores differ, not only in words.
  bool is_changed = false;
  bool is_stored = false;
  /// Why it was not scored: a recording that is erased or damaged, a text that does not fit the
  /// bone.
  std::string fault;
};

/// Oldest first: of the operation what the desks list and may score, but what is void or being
/// recorded.
/// needs   the desks hold the right to score what they list (no trainee's)
/// errors  DatabaseError: NotFound where there is no such attempt or version; Refused; storage
///         failures. Cancelled: what was stored before stays, and the sentence says how many those
///         are
std::vector<RescoredAttempt> rescore(database::Database& database,
                                     std::vector<database::AttemptDesk>& desks,
                                     const Rescoring& rescoring, const Progress& progress);

}  // namespace hallux::ui
