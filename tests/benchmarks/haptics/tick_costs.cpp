#include "tests/benchmarks/haptics/tick_costs.h"

#include <exception>
#include <iostream>

#include "tests/benchmarks/report/table.h"
#include "tests/benchmarks/worlds/bone_like.h"
#include "tests/simulator/step/simulation_run.h"

namespace hallux::benchmarks {

namespace {

Table table_of(const TickCosts& costs, const std::vector<std::size_t>& sizes) {
  Table table{
      .name = costs.name,
      .title = costs.title,
      .columns = {"triangles", "while", costs.counted, "p50 us", "p99 us", "greatest us"},
      .rows = {},
      .notes = {"a million square roots in a row take " + text_of(calibration_ms()) + " ms here"}};
  for (const std::size_t triangles : sizes) {
    simulator::Bone bone = tests::cortical_bone(make_bone_like({triangles, false}));
    bone.cortex = simulator::CortexLaw{.length_mm = 62.0};
    for (const TickWork& work : costs.work) {
      const Percentiles spread = work.cost_us(bone);
      table.rows.push_back({static_cast<double>(bone.outer.triangles.size()), work.what,
                            static_cast<double>(spread.count), spread.median, spread.p99,
                            spread.greatest});
    }
  }
  return table;
}

}  // namespace

int print_tick_costs(const TickCosts& costs, int count, char** words) {
  try {
    std::vector<std::size_t> sizes;
    for (int i = 1; i < count; ++i) sizes.push_back(std::stoul(words[i]));
    if (sizes.empty()) sizes = {5'000, 50'000, 500'000};
    print_table(std::cout, table_of(costs, sizes));
  } catch (const std::exception& error) {
    std::cerr << costs.program << ": " << error.what() << "\nusage: " << costs.program
              << " [TRIANGLES...]\n";
    return 2;
  }
  return 0;
}

}  // namespace hallux::benchmarks
