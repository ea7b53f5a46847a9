#include "scenarios/geometry/part_path.h"

namespace hallux::scenarios {

std::string part_path(const Scenario& scenario, std::string_view list, std::size_t index,
                      const std::string& name) {
  return scenario.name + ": " + std::string(list) + "[" + std::to_string(index) + "] \"" + name +
         "\"";
}

}  // namespace hallux::scenarios
