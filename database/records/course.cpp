#include "database/records/course.h"

#include "database/records/names.h"

namespace hallux::database {

namespace {

constexpr std::array<std::string_view, 3> state_names{"draft", "published", "retired"};

}  // namespace

std::string_view name_of(ScenarioState state) noexcept { return name_in(state_names, state); }

std::optional<ScenarioState> scenario_state_from(std::string_view name) noexcept {
  return named_in<ScenarioState>(state_names, name);
}

}  // namespace hallux::database
