#include "scenarios/plan_digest.h"

#include <nlohmann/json.hpp>

namespace hallux::scenarios {

Digest plan_digest(const Scenario& scenario, const Digest& bone) {
  // Keys of a json are in alphabetical order.
  nlohmann::json asked = nlohmann::json::parse(scenario.text);
  for (const char* not_measured_by : {"version", "reviewed", "reviewed_by", "title", "summary",
                                      "indication", "sources", "rubric", "proof"})
    asked.erase(not_measured_by);
  Digester digester;
  digester.add_text(asked.dump());
  digester.add_digest(bone);
  return digester.finish();
}

}  // namespace hallux::scenarios
