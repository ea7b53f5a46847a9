#include "ui/jobs/course/course_jobs.h"

#include <algorithm>

#include "ui/jobs/course/scenario_jobs.h"

namespace hallux::ui {

namespace {

database::ScenarioText text_of(const scenarios::Scenario& scenario) {
  return {scenario.name, scenario.version, scenario.text, scenario.claims_review};
}

}  // namespace

std::vector<database::ScenarioVersionId> publish_shipped_scenarios(
    database::AdministratorDesk& desk) {
  const std::vector<database::ScenarioVersion> known = desk.scenarios();
  std::vector<database::ScenarioVersionId> published;
  for (const scenarios::Scenario& scenario : list_scenarios()) {
    const bool has_one =
        std::any_of(known.begin(), known.end(), [&](const database::ScenarioVersion& version) {
          return version.name == scenario.name &&
                 version.state == database::ScenarioState::Published;
        });
    if (has_one) continue;
    published.push_back(desk.import_scenario(text_of(scenario)));
    desk.publish_scenario(published.back());
  }
  return published;
}

database::ScenarioVersionId import_scenario(database::AdministratorDesk& desk,
                                            const scenarios::Scenario& scenario) {
  return desk.import_scenario(text_of(scenario));
}

}  // namespace hallux::ui
