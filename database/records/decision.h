/// Decision of an instructor about the result of an attempt. The computed score stays beside it.
/// Inside this room only.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "database/records/ids.h"
#include "database/records/names.h"

namespace hallux::database {

enum class DecisionKind {
  /// The machine's score stands.
  Confirmed,
  /// Another score stands in its place.
  Overridden,
  /// The attempt does not count.
  Voided
};

template <>
inline constexpr std::array<std::string_view, 3> stored_names<DecisionKind>{"confirmed",
                                                                            "overridden", "voided"};

struct NewDecision {
  AttemptId attempt;
  DecisionKind kind = DecisionKind::Confirmed;
  /// Overridden: 0 to 100 000; of the other kinds it is not read.
  std::int64_t score_milli = 0;
  /// Never empty.
  std::string reason;
};

struct Decision {
  DecisionId id;
  AttemptId attempt;
  DecisionKind kind = DecisionKind::Voided;
  /// The machine's score it was about; a voided attempt may have none.
  std::optional<ScoreId> about;
  /// That stands; nothing: voided.
  std::optional<std::int64_t> score_milli;
  std::string reason;
  /// Shown name; "" for erased people.
  std::string decided_by;
  std::string decided_utc;
  bool is_in_force = false;
};

}  // namespace hallux::database
