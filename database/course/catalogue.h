/// The catalogue of scenario versions: draft, published, retired; and the operations that are
/// published. Inside this room only.
///
///   import -> draft -> published -> retired -> published ...
///
/// A name has at most one published version: publishing another retires it. A text that was
/// published keeps its number for good: another text under the same name and version is refused.
/// Attempts keep the version they were made with.
#pragma once

#include <vector>

#include "database/content/assets.h"
#include "database/records/course.h"
#include "database/store/connection.h"

namespace hallux::database {

/// Takes the text into the catalogue as a draft; the same text again changes nothing. The text was
/// checked before: this room does not know what a scenario is.
/// errors  DatabaseError BadInput where another text was published under that name and version
ScenarioVersionId import_scenario(Database& database, const ScenarioText& text, PersonId by);

/// errors  DatabaseError: NotFound; BadInput where it is published already, or another text was
///         published under its version
void publish_scenario(Database& database, ScenarioVersionId id, PersonId by);

/// errors  DatabaseError: NotFound; BadInput where it is not published
void retire_scenario(Database& database, ScenarioVersionId id, PersonId by);

/// The whole catalogue by name, newest version first.
std::vector<ScenarioVersion> list_scenario_versions(Database& database);
/// errors  DatabaseError NotFound where the catalogue has no such version
ScenarioVersion load_scenario_version(Database& database, ScenarioVersionId id);
bool is_published(Database& database, ScenarioVersionId id);

/// What is published, by name, with how `person` stands in each and how many assessments are left.
std::vector<Operation> list_operations(Database& database, PersonId person);

}  // namespace hallux::database
