// What it takes to score a course anew after weights were changed: from what was measured, and, for
// one attempt beside it, from its recording.
#include <algorithm>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <nlohmann/json.hpp>

#include "database/content/assets.h"
#include "tests/benchmarks/report/percentiles.h"
#include "tests/benchmarks/report/table.h"
#include "tests/database/some_database.h"
#include "ui/jobs/made_attempt.h"
#include "ui/jobs/rescore_jobs.h"

namespace hallux::benchmarks {

namespace {

using database::Database;
using database::Medium;
using database::TemporaryDirectory;

const ui::StageProgress untold = [](const std::string&) { return Progress(); };

/// The next version of a scenario: two items of a group have changed weights.
scenarios::Scenario otherwise_weighted(const scenarios::Scenario& scenario) {
  auto text = nlohmann::ordered_json::parse(scenario.text);
  text["version"] = scenario.version + 1;
  nlohmann::ordered_json& items = text["rubric"]["items"];
  const auto other = std::ranges::find_if(items, [&](const nlohmann::ordered_json& item) {
    return item["group"] == items[0]["group"] && item["weight"] != items[0]["weight"];
  });
  std::swap(items[0]["weight"], (*other)["weight"]);
  return scenarios::parse_scenario(text.dump(), scenario.name);
}

database::ScenarioVersionId stored_version(Database& database,
                                           const scenarios::Scenario& scenario) {
  return database::put_scenario_version(database,
                                        {scenario.name, scenario.version, scenario.text, false});
}

/// Attempts with a short recording and the score and measurements of a whole one: a score from
/// measurements looks at no recording.
void fill(Database& database, const ui::AttemptMaterial& material,
          const assessment::Examination& examination, int attempts) {
  database::HouseDesk desk(database);
  database::NewAttempt begun = database::some_attempt(database);
  begun.scenario = stored_version(database, material.scenario);
  begun.engine = material.recording.engine;
  const database::MeasuredBy by = ui::measured_by(material.scenario, begun.bone);
  const simulator::Recording recording = database::some_recording(5);
  for (int i = 0; i < attempts; ++i) {
    const database::AttemptId id = database::record(database, begun, recording);
    desk.store_score(id, examination.card);
    desk.store_measurements(id, by, examination.measurements);
  }
}

template <typename Work>
void add_row(Table& table, const std::string& what, double attempts, Work work) {
  const Stopwatch watch;
  work();
  const double wall_ms = watch.milliseconds();
  table.rows.push_back({what, attempts, wall_ms, watch.worked_milliseconds(), wall_ms / attempts});
}

Table rescoring(const std::string& name, int attempts) {
  const TemporaryDirectory temporary{Medium::Disk};
  Database database = Database::open(temporary.data());
  ui::ScriptedAttempt expert;
  expert.scenario = scenarios::load_shipped_scenario(name);
  const ui::AttemptMaterial material = ui::make_attempt(expert, untold).material;
  const assessment::Examination examination = ui::score_attempt(material, untold);
  fill(database, material, examination, attempts);
  std::vector<database::AttemptDesk> house{database::HouseDesk(database)};
  Table table{
      .name = "rescoring_" + name,
      .title = name + ": weights changed, " + std::to_string(examination.measurements.size()) +
               " measurements an attempt",
      .columns = {"what", "attempts", "wall ms", "processor ms", "ms an attempt"},
      .rows = {},
      .notes = {"a million square roots in a row take " + text_of(calibration_ms()) + " ms here"}};
  const scenarios::Scenario other = otherwise_weighted(expert.scenario);
  const std::vector<ui::KnownVersion> known{{name, other.version, stored_version(database, other)}};
  const auto rescore = [&](bool is_dry) {
    ui::rescore(database, house, {name, other.version, is_dry, known}, {});
  };
  add_row(table, "from measurements, a dry run", attempts, [&] { rescore(true); });
  add_row(table, "from measurements, stored", attempts, [&] { rescore(false); });
  add_row(table, "from the recording", 1, [&] { ui::score_attempt(material, untold); });
  return table;
}

}  // namespace

}  // namespace hallux::benchmarks

int main(int argc, char** argv) {
  using namespace hallux::benchmarks;
  try {
    const int attempts = argc > 1 ? std::atoi(argv[1]) : 1000;
    for (const char* name : {"akin", "silver"}) print_table(std::cout, rescoring(name, attempts));
  } catch (const std::exception& error) {
    std::cerr << "rescore_table: " << error.what() << '\n';
    return 2;
  }
  return 0;
}
