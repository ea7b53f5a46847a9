/// Scores: a cache with versions. A new one supersedes the one in force; none is overwritten or
/// deleted. Inside this room only.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "database/records/ids.h"
#include "database/records/score.h"
#include "database/store/connection.h"
#include "simulator/base/digest.h"

namespace hallux::database {

struct StoredScore {
  ScoreId id;
  std::string stored_utc;
  ScoreCard card;
};

/// A card that is to be stored.
struct NewScore {
  AttemptId attempt;
  ScoreCard card;
};

/// Stores the card as the score in force, with an audit row that holds its digest and `actor`
/// (nobody: the house). A card that differs in nothing but its
/// sentences stores nothing.
/// errors  DatabaseError: NotFound; storage failures
ScoreId store_score(Database& database, const AttemptId& attempt, const ScoreCard& card,
                    std::optional<PersonId> actor = std::nullopt);

/// The same of a card as it was in another directory: where only its sentences differ from those in
/// force it is stored as well.
ScoreId store_score_as_it_was(Database& database, const AttemptId& attempt, const ScoreCard& card,
                              std::optional<PersonId> actor);

/// What the audit keeps of a stored score: its card, and whose it is.
Digest score_digest(std::string_view card_json, const AttemptId& attempt) noexcept;

/// The score in force; nothing where the attempt was not scored yet.
/// errors  DatabaseError
std::optional<StoredScore> load_score(Database& database, const AttemptId& attempt);

}  // namespace hallux::database
