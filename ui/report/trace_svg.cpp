// Curves over time as SVG: panels below each other with one axis of time, each with a scale of its
// own that ends at a tidy number. A value that is not known breaks the line. Marks of events run
// through all panels; a name that would lie on the one before is left out, its line stays.
#include "ui/report/trace_svg.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "assessment/number_text.h"
#include "ui/report/html_text.h"

namespace hallux::ui {

namespace {

/// The drawing, in its own units; the page scales it to its width.
constexpr double width = 860.0, left = 44.0, right = 12.0, panel_height = 110.0, panel_gap = 42.0;
constexpr double top = 30.0, bottom = 30.0;

using ValueAt = std::function<std::optional<double>(const Traces&, std::size_t point)>;

struct Panel {
  std::string title, css_class;
  ValueAt value_at;
  double value_min = 0.0;
  std::optional<double> limit = std::nullopt;  ///< drawn across
  double top = 0.0;
  double value_max = 1.0;
};

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
  const double share = (value - panel.value_min) / (panel.value_max - panel.value_min);
  return panel.top + panel_height * (1.0 - std::clamp(share, 0.0, 1.0));
}

/// The next tidy number above everything drawn.
double value_max_of(const Traces& traces, const Panel& panel) {
  double greatest = std::max(panel.value_min + 1.0, panel.limit.value_or(0.0));
  for (std::size_t point = 0; point < traces.points.size(); ++point) {
    greatest = std::max(greatest, panel.value_at(traces, point).value_or(0.0));
  }
  const double step = tidy_step(greatest - panel.value_min, 2.0);
  return panel.value_min + step * std::ceil((greatest - panel.value_min) / step);
}

std::string grid_svg(const Panel& panel) {
  std::string svg = svg_text(Vec2{left, panel.top - 10.0}, "start", "px title", panel.title);
  const double step = tidy_step(panel.value_max - panel.value_min, 2.0);
  for (double value = panel.value_min; value <= panel.value_max * 1.0001; value += step) {
    const double y = y_of(panel, value);
    svg += svg_line(Vec2{left, y}, Vec2{width - right, y}, "grid");
    svg += svg_text(Vec2{left - 8.0, y + 4.0}, "end", "px", assessment::short_number_text(value));
  }
  if (!panel.limit) return svg;
  const double y = y_of(panel, *panel.limit);
  svg += svg_line(Vec2{left, y}, Vec2{width - right, y}, "limit");
  return svg + svg_text(Vec2{width - right, y - 4.0}, "end", "px",
                        assessment::short_number_text(*panel.limit));
}

/// A line that is broken where there is nothing to show.
std::string curve_svg(const Traces& traces, const Panel& panel, double duration_s) {
  std::string path;
  bool is_drawing = false;
  for (std::size_t point = 0; point < traces.points.size(); ++point) {
    const std::optional<double> value = panel.value_at(traces, point);
    if (value) {
      path += (is_drawing ? "L" : "M") + coordinate(x_of(traces.points[point].time_s, duration_s)) +
              " " + coordinate(y_of(panel, *value));
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
    const double text_width = 7.5 * static_cast<double>(mark.text.size());
    const bool is_near_end = x + 0.5 * text_width > width - right;
    const double begin = x - (is_near_end ? 1.0 : 0.5) * text_width;
    if (begin < free_from) continue;
    svg += svg_text(Vec2{x, 12.0}, is_near_end ? "end" : "middle", "px", mark.text);
    free_from = begin + text_width + 8.0;
  }
  return svg;
}

/// Where the panel of heat begins: a round number below any bone.
constexpr double coolest_celsius = 20.0;

/// Over the stretch of time that begins at the point.
double feed_mm_s(const Traces& traces, std::size_t point) {
  const std::size_t next = std::min(point + 1, traces.points.size() - 1);
  const std::size_t from = next == point && point > 0 ? point - 1 : point;
  const double span_s = traces.points[next].time_s - traces.points[from].time_s;
  return span_s > 0.0 ? traces.points[point].fed_mm / span_s : 0.0;
}

std::vector<Panel> panels_of(const Traces& traces) {
  std::vector<Panel> panels{
      {"Force on the hand, N", "trace force",
       [](const Traces& of, std::size_t point) -> std::optional<double> {
         return of.points[point].force_newton;
       }},
      {"Feed of the teeth through bone, mm/s", "trace feed",
       [](const Traces& of, std::size_t point) -> std::optional<double> {
         return feed_mm_s(of, point);
       }},
      {"Advance of the teeth in the kerf, mm", "trace advance",
       [](const Traces& of, std::size_t point) { return of.points[point].advance_mm; }},
      {"Hottest bone by the model, °C", "trace heat",
       [](const Traces& of, std::size_t point) -> std::optional<double> {
         return of.points[point].hottest_celsius;
       },
       coolest_celsius, simulator::hot_celsius}};
  double panel_top = top + 16.0;
  for (Panel& panel : panels) {
    panel.top = panel_top;
    panel.value_max = value_max_of(traces, panel);
    panel_top += panel_height + panel_gap;
  }
  return panels;
}

}  // namespace

std::string trace_svg(const Traces& traces) {
  if (traces.points.empty()) return "";
  const double duration_s = std::max(traces.points.back().time_s, 0.001);
  const std::vector<Panel> panels = panels_of(traces);
  const double height = panels.back().top + panel_height + bottom;
  std::string svg =
      "<svg class=\"traces\" role=\"img\" aria-label=\"Force, feed, advance and heat over time\" "
      "viewBox=\"0 0 " +
      coordinate(width) + " " + coordinate(height) + "\">";
  for (const Panel& panel : panels) svg += grid_svg(panel);
  svg += marks_svg(traces, duration_s, height);
  for (const Panel& panel : panels) svg += curve_svg(traces, panel, duration_s);
  return svg + times_svg(duration_s, height) + "</svg>";
}

}  // namespace hallux::ui
