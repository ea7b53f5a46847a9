/// The operations as they were shipped last in format 1, which is read and scored for ever.
#pragma once

#include <string_view>

#include "scenarios/scenario.h"

namespace hallux::scenarios_test {

/// "akin" or "silver".
scenarios::Scenario format_1(std::string_view name);

}  // namespace hallux::scenarios_test
