#include "database/records/decision.h"

#include "database/records/names.h"

namespace hallux::database {

namespace {

constexpr std::array<std::string_view, 3> kind_names{"confirmed", "overridden", "voided"};

}  // namespace

std::string_view name_of(DecisionKind kind) noexcept { return name_in(kind_names, kind); }

std::optional<DecisionKind> decision_kind_from(std::string_view name) noexcept {
  return named_in<DecisionKind>(kind_names, name);
}

}  // namespace hallux::database
