/// The words by which refusals of a plan name a part of its scenario. Inside this corner only.
#pragma once

#include <string>
#include <string_view>

#include "scenarios/scenario.h"

namespace hallux::scenarios {

/// "akin: cuts[1] "distal_face"".
std::string part_path(const Scenario& scenario, std::string_view list, std::size_t index,
                      const std::string& name);

}  // namespace hallux::scenarios
