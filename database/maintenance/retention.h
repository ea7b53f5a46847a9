/// Retention rules and the clean-up they cause. Inside this room only.
///
/// Nothing goes unless an administrator set a time. A recording's time runs from its start, of an
/// assessment from the last decision about it where that is later; one with an open question stays.
/// What goes with a recording is what an erasure of it takes
/// (database/recording/erased_recordings.h): facts, seal and score stay. A closed account is one
/// that was disabled; it is erased (database/maintenance/erasures.h), its recordings have their own
/// time.
#pragma once

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "database/records/ids.h"
#include "database/records/names.h"
#include "database/store/connection.h"
#include "simulator/base/progress.h"

namespace hallux::database {

/// In days; nothing: for ever, as the program ships it.
struct RetentionRules {
  std::optional<std::int32_t> practice_days, assessment_days, account_days, cache_days;

  friend bool operator==(const RetentionRules&, const RetentionRules&) = default;
};

inline constexpr std::int32_t retention_days_most = 36'500;

enum class RetainedKind { Practice, Assessment, Account, Cache };

template <>
inline constexpr std::array<std::string_view, 4> stored_names<RetainedKind>{
    "practice", "assessment", "account", "cache"};

/// What would go.
struct RetentionPiece {
  RetainedKind kind = RetainedKind::Practice;
  /// An attempt's uuid, a person's number, a file of the cache.
  std::string name;
  /// Of whom it is; "" for nobody.
  std::string login;
  /// From when its time ran.
  std::string since_utc;
  std::int64_t bytes = 0;
};

struct RetentionDone {
  std::int64_t recordings = 0, accounts = 0, cached = 0, bytes = 0;
};

RetentionRules load_retention(Database& database);
/// errors  DatabaseError BadInput outside 1 to 36500 days
void store_retention(Database& database, const RetentionRules& rules);

/// Exactly what would go now, recordings by age, then accounts, then what is cached.
std::vector<RetentionPiece> plan_retention(Database& database);

/// Lets it go, each piece in a transaction of its own that asks once more; clears SQLite's log at
/// the end. Killed in the middle each piece is there or gone; once more goes on.
/// errors  DatabaseError: storage failures; Cancelled
RetentionDone apply_retention(Database& database, std::optional<PersonId> actor,
                              const Progress& progress = {});

}  // namespace hallux::database
