/// Charts as SVG, readable without the program that drew them: light ground, text beside colour.
#pragma once

#include <string>
#include <vector>

namespace hallux::benchmarks {

struct Series {
  std::string name;
  /// One per group or place; not above 0 where nothing was measured.
  std::vector<double> values;
};

/// Horizontal bars on a logarithmic scale, side by side in groups.
struct BarChart {
  std::string title;
  /// Said under the scale.
  std::string unit;
  /// One per value of a series.
  std::vector<std::string> groups;
  std::vector<Series> series;
};

/// Lines over a common axis, both scales linear from zero.
struct LineChart {
  std::string title;
  /// With units.
  std::string along_name, value_name;
  std::vector<double> along;
  std::vector<Series> series;
};

/// needs   every series has as many values as there are groups
std::string draw_bars(const BarChart& chart);
/// needs   no series has more values than `along`
std::string draw_lines(const LineChart& chart);

}  // namespace hallux::benchmarks
