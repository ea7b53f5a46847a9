// Walls that are stable, three force laws at a plate, and what the device's force costs a tick.
//
//     haptic_table [--out DIR]
//
// Tables are printed as Markdown and written as CSV, the plots of docs/haptics.md as SVG. All but
// the last table is computed in virtual time and the same on every machine.
#include <filesystem>
#include <iostream>
#include <string>

#include "simulator/device/modelled/modelled_arm.h"
#include "tests/benchmarks/report/percentiles.h"
#include "tests/benchmarks/report/table.h"
#include "tests/benchmarks/report/table_program.h"
#include "tests/screenshots/haptics/haptic_pictures.h"
#include "tests/simulator/device/wall_experiments.h"

namespace hallux::benchmarks {

namespace {

using tests::PlateLaw;

Table stiffest_walls() {
  Table table{
      .name = "haptic_walls",
      .title = "Stiffest calm wall: b = 5 N s/m, pushed with 2 N",
      .columns = {"delay ticks", "theory N/mm", "endless spring N/mm", "wall N/mm",
                  "with controller N/mm"},
      .rows = {},
      .notes = {"theory: b / (T / 2 + d T)",
                "wall: encoder of 15 um, motors of 8 N; in steps of a quarter of an octave"}};
  constexpr double calm_mm = 0.05;
  for (const tests::StabilityColumn& column : tests::map_stability()) {
    double plain = 0.0, passive = 0.0;
    for (const tests::StabilityCell& cell : column.cells) {
      if (cell.plain_range_mm >= calm_mm) break;
      plain = cell.stiffness_newton_per_mm;
    }
    for (const tests::StabilityCell& cell : column.cells) {
      if (cell.passive_range_mm >= calm_mm) break;
      passive = cell.stiffness_newton_per_mm;
    }
    table.rows.push_back({static_cast<double>(column.delay_ticks), column.theory_newton_per_mm,
                          column.measured_newton_per_mm, plain, passive});
  }
  return table;
}

Table laws_at_a_plate() {
  Table table{.name = "haptic_laws",
              .title = "Three laws at a plate of 5 mm: 1 N/mm, pushed with 2 N for 3 s",
              .columns = {"law", "updates 1/s", "deepest mm", "rest mm", "to and fro mm",
                          "switches", "speed at the end mm/s"},
              .rows = {},
              .notes = {"historic at 60: a plate of 4 mm is crossed between two frames, unseen"}};
  const std::pair<PlateLaw, std::string> laws[] = {
      {PlateLaw::Proxy, "spring to a proxy"},
      {PlateLaw::Penalty, "spring to the nearest face"},
      {PlateLaw::Thesis, "historic"}};
  for (const auto& [law, name] : laws) {
    for (const std::int64_t ticks : {17, 1}) {
      const tests::PlateResult result = tests::press_plate(law, ticks);
      table.rows.push_back({name, ticks == 1 ? 1000.0 : 60.0, result.deepest_mm, result.rest_mm,
                            result.range_mm, static_cast<double>(result.switches),
                            result.speed_mm_s});
    }
  }
  return table;
}

/// Of one call, from blocks of a thousand ticks with an arm in contact.
Table cost_of_a_tick() {
  using namespace simulator;
  const ModelledArmSetup setup;
  const ForceOutputSettings settings = force_output_settings(setup.limits, 2.0, 1);
  ForceOutputState state;
  std::vector<double> times_us;
  double sum_newton = 0.0;
  for (int block = 0; block < 300; ++block) {
    const Stopwatch watch;
    for (int tick = 0; tick < 1000; ++tick) {
      const double depth_mm = 0.002 * (tick < 500 ? tick : 1000 - tick);
      const DeviceForce force =
          output_force(state, settings, {{-2.0 * depth_mm, 0.0, 0.0}, {depth_mm, 0.0, 0.0}});
      sum_newton += force.force_in_world_newton.x;
    }
    times_us.push_back(watch.worked_milliseconds());  // of a thousand: microseconds of one
  }
  const Percentiles spread = percentiles_of(times_us);
  Table table{.name = "haptic_cost",
              .title = "What the device's force costs a tick, processor time, means of a thousand",
              .columns = {"p50 us", "p99 us", "greatest us"},
              .rows = {{spread.median, spread.p99, spread.greatest}},
              .notes = {}};
  if (!(sum_newton < 0.0)) throw std::runtime_error("the wall did not push");
  return table;
}

void run(const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  for (const Table& table : {stiffest_walls(), laws_at_a_plate(), cost_of_a_tick()}) {
    print_table(std::cout, table);
    write_csv(folder, table);
  }
  for (const tests::Picture& picture : tests::haptic_pictures()) {
    write_text(folder / ("haptic_" + picture.name + ".svg"), picture.svg);
  }
  std::cout << "\nCSV and SVG: " << folder.string() << '\n';
}

}  // namespace

}  // namespace hallux::benchmarks

int main(int count, char** words) {
  return hallux::benchmarks::table_program(count, words, "haptic_table", HALLUX_RESULTS,
                                           hallux::benchmarks::run);
}
