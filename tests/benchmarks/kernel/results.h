/// What the sections of the kernel's table hand over, and what they are given.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "tests/benchmarks/report/table.h"

namespace hallux::benchmarks {

struct Effort {
  /// Triangles; larger worlds are left out.
  std::size_t greatest_mesh = 2'000'000;
  std::size_t many_steps = 10'000;
  /// For the repeated Boolean in exact numbers.
  double exact_boolean_limit_s = 60.0;
};

struct NamedChart {
  /// Of the SVG file, without its ending.
  std::string name;
  std::string svg;
};

struct Results {
  std::vector<Table> tables;
  std::vector<NamedChart> charts;
  /// What came out wrong; a time is never one.
  std::vector<std::string> faults;
};

/// Adds a fault unless the two volumes agree within a millionth.
void expect_volume(Results& results, const std::string& what, double expected_mm3,
                   double found_mm3);

/// Times of the fixed piece of work.
void measure_calibration(const Effort& effort, Results& results);
/// One split and one slab by every peer and by us, with the goals as ratios.
void measure_peers(const Effort& effort, Results& results);
/// A whole cut frame by frame, in few steps and in many.
void measure_frames(const Effort& effort, Results& results);
/// A blade subtracted pose by pose, beside our frames.
void measure_repeated_boolean(const Effort& effort, Results& results);
/// Twelve cuts on a foot and on a sphere: the thesis's chapter 7.
void measure_twelve_cuts(const Effort& effort, Results& results);
/// The search tree with other parameters: the thesis's question 8.4.2.
void measure_tree(const Effort& effort, Results& results);

}  // namespace hallux::benchmarks
