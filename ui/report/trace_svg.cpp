#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include "assessment/number_text.h"
#include "ui/report/html_text.h"
#include "ui/report/report_svg.h"

namespace hallux::ui {

namespace {

/// The drawing, in its own units; the page scales it to its width.
constexpr double width = 860.0, left = 44.0, right = 12.0, panel_height = 110.0, panel_gap = 42.0;
constexpr double top = 30.0, bottom = 30.0;

struct Panel {
  double top = 0.0;
  double value_max = 1.0;
  std::string title, css_class;
};

using ValueAt = std::function<std::optional<double>(const TracePoint&)>;

/// 1, 2 or 5 times a power of ten, so that about `wanted` steps fill the range.
double tidy_step(double range, double wanted) {
  const double rough = range / wanted;
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= rough) return factor * power;
  }
  return 10.0 * power;
}

double x_of(double time_s, double duration_s) {
  return left + (width - left - right) * time_s / duration_s;
}

double y_of(const Panel& panel, double value) {
  return panel.top + panel_height * (1.0 - std::clamp(value / panel.value_max, 0.0, 1.0));
}

/// The next tidy number above everything drawn.
double value_max_of(const Traces& traces, const ValueAt& value_at) {
  double greatest = 1.0;
  for (const TracePoint& point : traces.points) {
    greatest = std::max(greatest, value_at(point).value_or(0.0));
  }
  const double step = tidy_step(greatest, 2.0);
  return step * std::ceil(greatest / step);
}

std::string grid_svg(const Panel& panel) {
  std::string svg = svg_text(Vec2{left, panel.top - 10.0}, "start", "px title", panel.title);
  const double step = tidy_step(panel.value_max, 2.0);
  for (double value = 0.0; value <= panel.value_max * 1.0001; value += step) {
    const double y = y_of(panel, value);
    svg += svg_line(Vec2{left, y}, Vec2{width - right, y}, "grid");
    svg += svg_text(Vec2{left - 8.0, y + 4.0}, "end", "px", assessment::short_number_text(value));
  }
  return svg;
}

/// A line that is broken where there is nothing to show.
std::string curve_svg(const Traces& traces, const Panel& panel, double duration_s,
                      const ValueAt& value_at) {
  std::string path;
  bool is_drawing = false;
  for (const TracePoint& point : traces.points) {
    const std::optional<double> value = value_at(point);
    if (value) {
      path += (is_drawing ? "L" : "M") + coordinate(x_of(point.time_s, duration_s)) + " " +
              coordinate(y_of(panel, *value));
    }
    is_drawing = value.has_value();
  }
  return "<path d=\"" + path + "\" class=\"" + panel.css_class + "\"/>";
}

std::string times_svg(double duration_s, double height) {
  std::string svg;
  const double step = tidy_step(duration_s, 8.0);
  for (double time_s = 0.0; time_s <= duration_s * 1.0001; time_s += step) {
    svg += svg_text(Vec2{x_of(time_s, duration_s), height - 8.0}, "middle", "px",
                    assessment::short_number_text(time_s) + " s");
  }
  return svg;
}

/// Names are left out where they would lie on the one before.
std::string marks_svg(const Traces& traces, double duration_s, double height) {
  std::string svg;
  double free_from = 0.0;
  for (const TraceMark& mark : traces.marks) {
    const double x = x_of(mark.time_s, duration_s);
    svg += svg_line(Vec2{x, top - 12.0}, Vec2{x, height - bottom}, "event");
    if (x < free_from) continue;
    const double text_width = 7.0 * static_cast<double>(mark.text.size());
    const bool is_near_end = x + text_width > width - right;
    svg += svg_text(Vec2{x, 12.0}, is_near_end ? "end" : "middle", "px", mark.text);
    free_from = x + text_width + 8.0;
  }
  return svg;
}

}  // namespace

std::string trace_svg(const Traces& traces) {
  if (traces.points.empty()) return "";
  const ValueAt force = [](const TracePoint& point) { return std::optional(point.force_newton); };
  const ValueAt advance = [](const TracePoint& point) { return point.advance_mm; };
  const double duration_s = std::max(traces.points.back().time_s, 0.001);
  const double height = top + 16.0 + 2.0 * panel_height + panel_gap + bottom;
  const Panel forces{top + 16.0, value_max_of(traces, force), "Force on the hand, N",
                     "trace force"};
  const Panel advances{top + 16.0 + panel_height + panel_gap, value_max_of(traces, advance),
                       "Advance of the teeth in the kerf, mm", "trace advance"};
  std::string svg =
      "<svg class=\"traces\" role=\"img\" aria-label=\"Force and advance over time\" "
      "viewBox=\"0 0 " +
      coordinate(width) + " " + coordinate(height) + "\">";
  svg += grid_svg(forces) + grid_svg(advances);
  svg += marks_svg(traces, duration_s, height);
  svg += curve_svg(traces, forces, duration_s, force);
  svg += curve_svg(traces, advances, duration_s, advance);
  return svg + times_svg(duration_s, height) + "</svg>";
}

}  // namespace hallux::ui
