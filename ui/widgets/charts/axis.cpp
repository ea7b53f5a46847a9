#include "ui/widgets/charts/axis.h"

#include <cmath>
#include <cstdio>

#include "simulator/base/check.h"

namespace hallux::ui {
namespace {

struct Column {
  float x = 0.0F, first = 0.0F, low = 0.0F, high = 0.0F, last = 0.0F;
  bool is_low_first = true;
};

void append(std::vector<Point>& run, const Column& column) {
  run.push_back({column.x, column.first});
  if (column.low == column.high) return;
  run.push_back({column.x, column.is_low_first ? column.low : column.high});
  run.push_back({column.x, column.is_low_first ? column.high : column.low});
  run.push_back({column.x, column.last});
}

// One run without gaps, a column of samples at a time.
std::vector<Point> decimated(const Plot& plot, std::span<const ChartPoint> points) {
  std::vector<Point> run;
  if (static_cast<float>(points.size()) <= plot.rect.w) {
    for (const ChartPoint& point : points) run.push_back({plot.x(point.x), plot.y(point.y)});
    return run;
  }
  Column column;
  bool is_open = false;
  for (const ChartPoint& point : points) {
    const float x = std::floor(plot.x(point.x)), y = plot.y(point.y);
    if (is_open && x == column.x) {
      if (y > column.low) column.low = y, column.is_low_first = false;
      if (y < column.high) column.high = y, column.is_low_first = true;
      column.last = y;
      continue;
    }
    if (is_open) append(run, column);
    column = {x, y, y, y, y, true};
    is_open = true;
  }
  if (is_open) append(run, column);
  return run;
}

}  // namespace

std::vector<double> nice_ticks(double low, double high, int most) {
  CHECK(low < high && most >= 2);
  // From fine to coarse: the first step with few enough ticks.
  const double finest = std::floor(std::log10((high - low) / most));
  for (double power = std::pow(10.0, finest);; power *= 10.0)
    for (const double factor : {1.0, 2.0, 5.0}) {
      const double step = factor * power;
      const double first = std::ceil(low / step - 1e-9), last = std::floor(high / step + 1e-9);
      if (last - first + 1.0 > most) continue;
      std::vector<double> ticks;
      for (double number = first; number <= last; number += 1.0) ticks.push_back(number * step);
      return ticks;
    }
}

std::string tick_text(double value, double step) {
  const int decimals =
      step >= 1.0 - 1e-9 ? 0 : static_cast<int>(std::ceil(-std::log10(step) - 1e-9));
  const double shown = std::abs(value) < step * 1e-6 ? 0.0 : value;
  char digits[32];
  std::snprintf(digits, sizeof digits, "%.*f", decimals, std::abs(shown));
  return (shown < 0.0 ? "\xE2\x88\x92" : "") + std::string(digits);
}

std::vector<std::vector<Point>> line_runs(const Plot& plot, std::span<const ChartPoint> points) {
  std::vector<std::vector<Point>> runs;
  std::size_t begin = 0;
  while (begin < points.size()) {
    if (std::isnan(points[begin].y)) {
      ++begin;
      continue;
    }
    std::size_t end = begin;
    while (end < points.size() && !std::isnan(points[end].y)) ++end;
    runs.push_back(decimated(plot, points.subspan(begin, end - begin)));
    begin = end;
  }
  return runs;
}

}  // namespace hallux::ui
