/// What ticks cost on bones of several sizes, printed as a table by a program of its own.
#pragma once

#include <string>
#include <vector>

#include "simulator/mesh/bone.h"
#include "tests/benchmarks/report/percentiles.h"

namespace hallux::benchmarks {

/// Ticks of one kind.
struct TickWork {
  /// In the column "while".
  std::string what;
  /// Processor time of each tick on a bone [us].
  Percentiles (*cost_us)(const simulator::Bone& bone);
};

struct TickCosts {
  std::string program, name, title;
  /// What is counted: ticks, or calls.
  std::string counted;
  std::vector<TickWork> work;
};

/// Prints the table as Markdown, for bones of as many triangles as the words say, else of 5,000,
/// 50,000 and 500,000.
/// returns  the exit status; 2 and a line of usage where a word is no number
int print_tick_costs(const TickCosts& costs, int count, char** words);

}  // namespace hallux::benchmarks
