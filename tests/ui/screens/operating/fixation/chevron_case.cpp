#include "tests/ui/screens/operating/fixation/chevron_case.h"

#include <span>

#include "simulator/base/embedded.h"

namespace hallux::ui_test {
std::span<const EmbeddedText> fixated_scenarios() noexcept;
}

namespace hallux::ui {

PreparedCase chevron_case(double edge_mm) {
  const EmbeddedText& file = ui_test::fixated_scenarios().front();
  scenarios::Scenario parsed = scenarios::parse_scenario(file.text, file.name);
  parsed.patient.edge_mm = edge_mm;
  return prepare_case(parsed, [](const std::string&) { return Progress(); });
}

}  // namespace hallux::ui
