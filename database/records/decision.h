/// What an instructor decided about the result of an attempt. The machine's score is kept beside it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "database/records/ids.h"

namespace hallux::database {

enum class DecisionKind {
  Confirmed,   ///< the machine's score stands
  Overridden,  ///< another score stands in its place
  Voided       ///< the attempt does not count
};

std::string_view name_of(DecisionKind kind) noexcept;  ///< "confirmed", "overridden", "voided"
/// Nothing where `name` is none of the three.
std::optional<DecisionKind> decision_kind_from(std::string_view name) noexcept;

struct NewDecision {
  AttemptId attempt;
  DecisionKind kind = DecisionKind::Confirmed;
  std::int64_t score_milli = 0;  ///< Overridden: 0 to 100 000; of the other kinds it is not read
  std::string reason;            ///< never empty
};

struct Decision {
  DecisionId id;
  AttemptId attempt;
  DecisionKind kind = DecisionKind::Confirmed;
  std::optional<ScoreId>
      about;  ///< the machine's score it was about; a voided attempt may have none
  std::optional<std::int64_t> score_milli;  ///< that stands; nothing: voided
  std::string reason;
  std::string decided_by;  ///< shown name; "" for erased people
  std::string decided_utc;
  bool is_in_force = false;
};

}  // namespace hallux::database
