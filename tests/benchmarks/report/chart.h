/// Charts as SVG, readable without the program that drew them: light ground, text beside colour.
#pragma once

#include <string>
#include <vector>

namespace hallux::benchmarks {

struct Series {
  std::string name;
  std::vector<double> values;  ///< one per group or place; not above 0 where nothing was measured
};

/// Horizontal bars on a logarithmic scale, side by side in groups.
struct BarChart {
  std::string title;
  std::string unit;                 ///< said under the scale
  std::vector<std::string> groups;  ///< one per value of a series
  std::vector<Series> series;
};

/// Lines over a common axis, both scales linear from zero.
struct LineChart {
  std::string title;
  std::string along_name, value_name;  ///< with units
  std::vector<double> along;
  std::vector<Series> series;
};

/// needs   every series has as many values as there are groups
std::string draw_bars(const BarChart& chart);
/// needs   no series has more values than `along`
std::string draw_lines(const LineChart& chart);

}  // namespace hallux::benchmarks
