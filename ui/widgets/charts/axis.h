/// Scales of charts: nice steps, where a value lies, and how many samples one pixel column shows.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "ui/widgets/look/geometry.h"

namespace hallux::ui {

/// Values in steps of 1, 2 or 5 times a power of ten that cover [low, high] with at most `most` of
/// them.
/// needs  low < high, most >= 2
std::vector<double> nice_ticks(double low, double high, int most);

/// A number as an axis shows it: no more decimals than `step` has, the true minus.
std::string tick_text(double value, double step);

/// Where values lie in the plot.
struct Plot {
  Rect rect = {};
  double x_low = 0.0, x_high = 1.0, y_low = 0.0, y_high = 1.0;

  float x(double value) const noexcept {
    return rect.x + static_cast<float>((value - x_low) / (x_high - x_low)) * rect.w;
  }
  float y(double value) const noexcept {
    return rect.bottom() - static_cast<float>((value - y_low) / (y_high - y_low)) * rect.h;
  }
  double value_at(float place_x) const noexcept {
    return x_low + (x_high - x_low) * static_cast<double>((place_x - rect.x) / rect.w);
  }
};

struct ChartPoint {
  double x = 0.0,
         /// y is not a number where nothing was measured: a gap is drawn, never a line through it.
      y = 0.0;
};

/// The points of a line in the plot, one run of them between two gaps. With more than one sample
/// per pixel a column keeps its lowest and highest, so that no peak is lost.
std::vector<std::vector<Point>> line_runs(const Plot& plot, std::span<const ChartPoint> points);

}  // namespace hallux::ui
