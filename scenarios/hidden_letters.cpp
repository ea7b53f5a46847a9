#include "scenarios/hidden_letters.h"

#include <nlohmann/json.hpp>
#include <string>

#include "scenarios/scenario_error.h"
#include "simulator/base/utf8.h"

namespace hallux::scenarios {

void check_letters(std::string_view json, std::string_view file) {
  const nlohmann::json values = nlohmann::json::parse(json).flatten();
  for (const auto& [place, value] : values.items()) {
    const bool is_hiding = has_hidden_letters(place) ||
                           (value.is_string() && has_hidden_letters(value.get<std::string>()));
    if (!is_hiding) continue;
    throw ScenarioError(std::string(file) + ": the text at " + place +
                        " holds letters that nobody sees (controls, or marks that turn the "
                        "direction of writing); write it without them");
  }
}

}  // namespace hallux::scenarios
