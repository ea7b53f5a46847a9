#include "tests/scenarios/format_1/format_1.h"

#include <span>
#include <string>

#include "simulator/base/embedded.h"

namespace hallux::scenarios_test {

std::span<const EmbeddedText> format_1_files() noexcept;

scenarios::Scenario format_1(std::string_view name) {
  const std::string file = std::string(name) + ".json";
  for (const EmbeddedText& embedded : format_1_files()) {
    if (embedded.name == file) return scenarios::parse_scenario(embedded.text, file);
  }
  throw scenarios::ScenarioError("no operation of format 1 is called " + std::string(name));
}

}  // namespace hallux::scenarios_test
