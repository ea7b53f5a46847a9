/// What verbs and screens do with the catalogue of a course: fill it with what ships, take a
/// checked file into it.
#pragma once

#include <filesystem>
#include <vector>

#include "database/desks/administrator_desk.h"

namespace hallux::ui {

/// Imports and publishes the shipped scenarios, except those whose name has a published version
/// already. For a new data directory: without it, nobody has an operation to choose.
/// errors  DatabaseError
std::vector<database::ScenarioVersionId> publish_shipped_scenarios(
    database::AdministratorDesk& desk);

/// Checks the file on its patient and imports it as a draft. About a second: a job.
/// errors  ScenarioError, which stores nothing; DatabaseError
database::ScenarioVersionId import_scenario_file(database::AdministratorDesk& desk,
                                                 const std::filesystem::path& file);

}  // namespace hallux::ui
