/// The parts of the display buffers' benchmark, and what they hand over.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "tests/benchmarks/report/table.h"

namespace hallux::benchmarks {

struct BufferEffort {
  bool is_quick = false;
  std::size_t repetitions = 5;
  std::size_t subdivided_at_most = 40'000;
};

struct BufferResults {
  struct Chart {
    std::string name, svg;
  };
  std::vector<Table> tables;
  std::vector<Chart> charts;
  /// What came out wrong; a time is never one.
  std::vector<std::string> faults;
};

/// Thesis figures 7.3 to 7.10: 21 growth schemes, two meshes, two works, two buffers.
void measure_growth(const BufferEffort& effort, BufferResults& results);
/// Thesis figure 7.11: removal with and without the overwrite trick, and what may have reversed it
/// there.
void measure_removal(const BufferEffort& effort, BufferResults& results);
/// What a frame sends, by how near changes are joined; and what blanks cost when drawn.
void measure_uploads(const BufferEffort& effort, BufferResults& results);

}  // namespace hallux::benchmarks
