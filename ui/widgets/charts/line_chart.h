/// Values over attempts or time: points, their running median, a pass mark.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ui/widgets/canvas.h"
#include "ui/widgets/charts/axis.h"
#include "ui/widgets/look/theme.h"

namespace hallux::ui {

/// Whose values they are; decides colour and stroke together.
enum class SeriesRole { You, Median };

struct Series {
  SeriesRole role = SeriesRole::You;
  /// In the legend.
  std::string name = {};
  /// x ascending.
  std::vector<ChartPoint> points = {};
  bool has_line = true, has_marks = false;
};

struct LineChart {
  /// Above the axis: "Points".
  std::string y_unit = {};
  /// At the right end: "Attempt".
  std::string x_name = {};
  double x_low = 0.0, x_high = 1.0, y_low = 0.0, y_high = 100.0;
  std::vector<Series> series = {};
  std::optional<double> pass_mark = {};
  /// "pass 70".
  std::string pass_name = {};
  /// The point of the first series that is pointed at.
  std::optional<std::size_t> looked_at = {};
};

/// Draws it into `rect`; its frame, legend and ticks take their room inside.
void draw_line_chart(Canvas& canvas, const Theme& theme, const Rect& rect, const LineChart& chart);

/// Where values lie when the chart is drawn into `rect`.
Plot plot_of(const Rect& rect, const LineChart& chart);

/// The point of the first series nearest to `place` across, within 24 px; nothing elsewhere.
std::optional<std::size_t> point_near(const Rect& rect, const LineChart& chart, Point place);

}  // namespace hallux::ui
