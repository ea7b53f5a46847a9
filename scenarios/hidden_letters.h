/// Letters that nobody sees, in the texts of a scenario that comes from outside.
#pragma once

#include <string_view>

namespace hallux::scenarios {

/// Refuses them in any text of this JSON, keys included: what a surgeon reads must be what is
/// there. Stored scenarios, which attempts were made under, are not asked.
/// needs   JSON that was parsed before
/// errors  ScenarioError naming `file` and the value
void check_letters(std::string_view json, std::string_view file);

}  // namespace hallux::scenarios
