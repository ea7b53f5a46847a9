// What it takes to show an attempt again: the bone rebuilt from the recording and from kept fields,
// a replay opened, and any moment of it shown.
#include <exception>
#include <iostream>

#include "assessment/rebuild/rebuild.h"
#include "scenarios/plan.h"
#include "scenarios/scenario.h"
#include "simulator/base/random.h"
#include "tests/benchmarks/report/percentiles.h"
#include "tests/benchmarks/report/table.h"
#include "tests/scenarios/hands/scripted_attempt.h"
#include "ui/jobs/cached_fields.h"
#include "ui/screens/replay/history_picture.h"

namespace hallux::benchmarks {

namespace {

using assessment::OpenedFields;

struct Attempt {
  explicit Attempt(const std::string& name) : scenario(scenarios::load_shipped_scenario(name)) {
    bone = make_patient_bones(scenario).front();
    plan = plan_on(scenario, bone);
    recording = tests::run_hand(scenario, bone, "expert", 1).recording;
  }
  OpenedFields followed() const {
    return assessment::opened_fields(scenario.saw.blade, bone, recording);
  }
  std::shared_ptr<const simulator::BoneHistory> history(OpenedFields opened) const {
    return simulator::build_history(
        {bone, recording, std::move(opened), scenarios::planned_bridges(plan)});
  }

  scenarios::Scenario scenario;
  simulator::Bone bone;
  scenarios::Plan plan;
  simulator::Recording recording;
};

void add_row(Table& table, const char* what, const Percentiles& spread) {
  table.rows.push_back(
      {what, static_cast<double>(spread.count), spread.median, spread.p99, spread.greatest});
}

Percentiles scrubbing_ms(const Attempt& attempt) {
  const auto history = attempt.history(attempt.followed());
  simulator::BoneMoment moment(*history);
  Random random(1, "scrubbing");
  std::vector<double> times_ms;
  for (int i = 0; i < 300; ++i) {
    const double part = random.uniform(0.0, 1.0);
    const auto tick = static_cast<std::int64_t>(
        part * static_cast<double>(attempt.recording.samples.back().tick));
    const Stopwatch watch;
    moment.move_to(tick);
    times_ms.push_back(watch.worked_milliseconds());
  }
  return percentiles_of(std::move(times_ms));
}

Table table_of(const std::string& name) {
  const Attempt attempt(name);
  const OpenedFields fields = attempt.followed();
  const std::vector<std::byte> bytes = ui::bytes_of(fields);
  const ui::BoneLook look = ui::look_of(1, attempt.bone);
  const auto nothing = [] { return 0; };
  const auto& blade = attempt.scenario.saw.blade;
  Table table{
      .name = "replay_" + name,
      .title = "Showing an expert's " + name + " of " +
               std::to_string(attempt.recording.samples.size() / 1000) + " s again, processor time",
      .columns = {"what", "times", "p50 ms", "p99 ms", "greatest ms"},
      .rows = {},
      .notes = {"a million square roots in a row take " + text_of(calibration_ms()) + " ms here",
                "kept fields take " + std::to_string(bytes.size()) + " bytes unpacked"}};
  add_row(table, "rebuilt from the recording", time_ms({}, nothing, [&](int) {
            return assessment::rebuild(attempt.bone, blade, attempt.recording);
          }));
  add_row(table, "fields followed", time_ms({}, nothing, [&](int) { return attempt.followed(); }));
  add_row(table, "fields read", time_ms({}, nothing, [&](int) { return ui::fields_from(bytes); }));
  add_row(table, "rebuilt from kept fields", time_ms({}, nothing, [&](int) {
            return assessment::rebuild(attempt.bone, blade, attempt.recording, {}, &fields);
          }));
  add_row(table, "the bone's look",
          time_ms({}, nothing, [&](int) { return ui::look_of(1, attempt.bone); }));
  add_row(table, "replay opened, fields and look at hand", time_ms({}, nothing, [&](int) {
            return ui::picture_of(attempt.history(fields), {look}, "opened");
          }));
  add_row(table, "a moment anywhere", scrubbing_ms(attempt));
  return table;
}

}  // namespace

}  // namespace hallux::benchmarks

int main(int count, char** words) {
  using namespace hallux::benchmarks;
  try {
    std::vector<std::string> names(words + 1, words + count);
    if (names.empty()) names = {"silver", "akin"};
    for (const std::string& name : names) print_table(std::cout, table_of(name));
  } catch (const std::exception& error) {
    std::cerr << "replay_table: " << error.what() << "\nusage: replay_table [OPERATION...]\n";
    return 2;
  }
  return 0;
}
