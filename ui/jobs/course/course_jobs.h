/// What verbs and screens do with the catalogue of a course: fill it with what ships, take a
/// checked file into it.
#pragma once

#include <vector>

#include "database/desks/administrator_desk.h"
#include "scenarios/scenario.h"

namespace hallux::ui {

/// Imports and publishes the shipped scenarios, except those whose name has a published version
/// already. For a new data directory: without it, nobody has an operation to choose.
/// errors  DatabaseError
std::vector<database::ScenarioVersionId> publish_shipped_scenarios(
    database::AdministratorDesk& desk);

/// Imports it as a draft.
/// needs   it was checked
/// errors  DatabaseError
database::ScenarioVersionId import_scenario(database::AdministratorDesk& desk,
                                            const scenarios::Scenario& scenario);

}  // namespace hallux::ui
