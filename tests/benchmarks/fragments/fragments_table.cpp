// What an operation costs after much was done to it: a step with 16 kerfs, three bodies and four
// wires beside one with two kerfs in one body, a tick that leads a piece beside one that saws, the
// memory of it all, and the job of pieces after the eighth kerf beside the second.
//
//     fragments_table [TRIANGLES]
//
// A bone-like shaft of 50,000 triangles, or as many as are said. Processor time, as Markdown. A
// slow run is no failure; a call of the step that asks the heap is.
#include <exception>
#include <iostream>
#include <string>

#include "simulator/cutting/field/kerf.h"
#include "tests/benchmarks/fragments/attempt_cost.h"
#include "tests/benchmarks/fragments/attempt_memory.h"
#include "tests/benchmarks/fragments/pieces_cost.h"
#include "tests/benchmarks/report/table.h"

namespace hallux::benchmarks {

namespace {

constexpr int rounds = 3;
constexpr double step_goal = 1.5, memory_goal = 1.0, pieces_goal = 4.0;

struct Spreads {
  Percentiles before, after;
};

void add_row(Table& table, const std::string& what, const Spreads& spreads, double goal) {
  table.rows.push_back({what, spreads.before.median, spreads.before.p99, spreads.after.median,
                        spreads.after.p99, spreads.after.median / spreads.before.median,
                        spreads.after.p99 / spreads.before.p99, goal > 0.0 ? Cell(goal) : Cell()});
}

Table step_table(AttemptCost two, AttemptCost sixteen) {
  Table table{
      .name = "fragments_step",
      .title = "What a call of the step costs after much was done, processor time",
      .columns = {"while", "before p50 us", "p99 us", "after p50 us", "p99 us",
                  "after / before p50", "p99", "goal p99"},
      .rows = {},
      .notes = {"before: two kerfs in one body; of a gripped piece: sawing beside it",
                "after: 16 kerfs, three bodies of which two were moved, four wires",
                std::to_string(two.heap_calls + sixteen.heap_calls) + " heap calls in all of them",
                "a million square roots in a row take " + text_of(calibration_ms()) + " ms here"}};
  const auto before = [&](const std::string& what) { return percentiles_of(two.times_us[what]); };
  const auto after = [&](const std::string& what) {
    return percentiles_of(sixteen.times_us[what]);
  };
  add_row(table, sawing, {before(sawing), after(sawing)}, step_goal);
  add_row(table, laying, {before(laying), after(laying)}, step_goal);
  add_row(table, leading, {after(sawing), after(leading)}, step_goal);
  add_row(table, pressing, {after(sawing), after(pressing)}, step_goal);
  add_row(table, boring, {before(boring), after(boring)}, 0.0);
  add_row(table, boring_late, {before(boring), after(boring_late)}, 0.0);
  return table;
}

Table memory_table(const AttemptMemory& memory) {
  const simulator::FieldGrid grid;
  const double field_mb =
      static_cast<double>(grid.u_count) * grid.v_count * sizeof(float) / (1024.0 * 1024.0);
  const double before_mb = 3.0 * 4.0 * field_mb;
  return {.name = "fragments_memory",
          .title = "Memory of a live attempt with 16 kerfs, beside four fields as arrays",
          .columns = {"what", "four arrays MB", "16 kerfs MB", "16 kerfs / four arrays", "goal"},
          .rows = {{"kerfs of step, jobs and picture", before_mb, memory.kerfs,
                    memory.kerfs / before_mb, memory_goal},
                   {"all of step, jobs and picture", before_mb, memory.attempt,
                    memory.attempt / before_mb, memory_goal}},
          .notes = {"arrays in each of step, jobs and picture, and of those the arrays alone"}};
}

Table pieces_table(const simulator::Bone& bone) {
  Table table{.name = "fragments_pieces",
              .title = "The job of pieces after one kerf more, processor time",
              .columns = {"kerfs", "after the 2nd p50 ms", "p99 ms", "after the 8th p50 ms",
                          "p99 ms", "8th / 2nd p50", "p99", "goal"},
              .rows = {},
              .notes = {}};
  for (const auto& [what, depth] : {std::pair{"half through, one body", KerfDepth::Half},
                                    std::pair{"through, a piece each", KerfDepth::Through}}) {
    const std::vector<Percentiles> costs = pieces_cost_ms(bone, depth);
    add_row(table, what, {costs[1], costs[7]}, pieces_goal);
  }
  return table;
}

/// Of both in turn, so that other work on the machine meets both.
bool print_all(std::size_t triangles) {
  const simulator::Bone bone = shaft(triangles);
  const DrivenRecording two = with_two_kerfs(bone), sixteen = with_sixteen_kerfs(bone);
  const AttemptMemory memory = memory_of(bone, sixteen);
  AttemptCost two_cost, sixteen_cost;
  for (int round = 0; round < rounds; ++round) {
    step_through(bone, two, two_cost);
    step_through(bone, sixteen, sixteen_cost);
  }
  print_table(std::cout, step_table(two_cost, sixteen_cost));
  print_table(std::cout, memory_table(memory));
  print_table(std::cout, pieces_table(bone));
  return two_cost.heap_calls + sixteen_cost.heap_calls == 0;
}

}  // namespace

}  // namespace hallux::benchmarks

int main(int count, char** words) {
  using namespace hallux::benchmarks;
  try {
    return print_all(count > 1 ? std::stoul(words[1]) : 50'000) ? 0 : 1;
  } catch (const std::exception& error) {
    std::cerr << "fragments_table: " << error.what() << "\nusage: fragments_table [TRIANGLES]\n";
    return 2;
  }
}
