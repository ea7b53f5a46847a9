#include "database/records/attempt.h"

#include "database/records/names.h"

namespace hallux::database {

namespace {

constexpr std::array<std::string_view, 4> state_names{"recording", "closed", "interrupted", "void"};
constexpr std::array<std::string_view, 2> kind_names{"practice", "assessment"};
constexpr std::array<std::string_view, 3> guidance_names{"none", "soft", "slot"};

}  // namespace

std::string_view name_of(AttemptState state) noexcept { return name_in(state_names, state); }

std::optional<AttemptState> attempt_state_from(std::string_view name) noexcept {
  return named_in<AttemptState>(state_names, name);
}

std::string_view name_of(AttemptKind kind) noexcept { return name_in(kind_names, kind); }

std::optional<AttemptKind> attempt_kind_from(std::string_view name) noexcept {
  return named_in<AttemptKind>(kind_names, name);
}

std::string_view name_of(simulator::Guidance guidance) noexcept {
  return name_in(guidance_names, guidance);
}

std::optional<simulator::Guidance> guidance_from(std::string_view name) noexcept {
  return named_in<simulator::Guidance>(guidance_names, name);
}

bool is_grade(const AttemptHeader& header) noexcept {
  const bool is_a_persons =
      header.begun.person && header.begun.hand.empty() && !header.is_simulated && header.is_counted;
  const bool is_whole =
      header.state == AttemptState::Closed && header.is_complete && header.is_valid.value_or(false);
  const bool is_stood_for =
      header.decided_milli && (header.decision == DecisionKind::Overridden || !header.is_partial);
  return is_a_persons && is_whole && is_stood_for && header.begun.kind == AttemptKind::Assessment;
}

}  // namespace hallux::database
