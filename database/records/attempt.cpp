#include "database/records/attempt.h"

#include <array>

namespace hallux::database {

namespace {

constexpr std::array<std::string_view, 4> state_names{"recording", "closed", "interrupted", "void"};

}  // namespace

std::string_view name_of(AttemptState state) noexcept {
  return state_names[static_cast<std::size_t>(state)];
}

std::optional<AttemptState> attempt_state_from(std::string_view name) noexcept {
  for (std::size_t i = 0; i < state_names.size(); ++i) {
    if (state_names[i] == name) return static_cast<AttemptState>(i);
  }
  return std::nullopt;
}

}  // namespace hallux::database
