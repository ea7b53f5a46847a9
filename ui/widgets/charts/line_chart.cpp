#include "ui/widgets/charts/line_chart.h"

#include <algorithm>
#include <cmath>

namespace hallux::ui {
namespace {

constexpr float axis_room = 38.0F, legend_room = 28.0F, unit_room = 26.0F, ticks_room = 50.0F,
                end_room = 6.0F;
constexpr float near_px = 24.0F;

struct SeriesLook {
  Color color;
  float thickness = 2.0F;
  bool is_dashed = false;
};

SeriesLook look_of(const Theme& theme, SeriesRole role) {
  return role == SeriesRole::Median ? SeriesLook{theme.text, 2.5F} : SeriesLook{theme.accent, 2.0F};
}

void draw_axes(Canvas& canvas, const Theme& theme, const Rect& rect, const Plot& plot,
               const LineChart& chart) {
  const std::vector<double> across = nice_ticks(chart.y_low, chart.y_high, 6);
  const double step = across.size() > 1 ? across[1] - across[0] : 1.0;
  for (const double value : across) {
    const float y = std::round(plot.y(value));
    canvas.fill({plot.rect.x, y, plot.rect.w, 1.0F}, value == chart.y_low ? theme.axis : theme.line,
                0.0F);
    canvas.text({plot.rect.x - 10.0F, y}, {Type::Caption, theme.text_caption, Align::Right},
                tick_text(value, step));
  }
  const int most = std::max(2, static_cast<int>(plot.rect.w / 36.0F));
  const std::vector<double> down = nice_ticks(chart.x_low, chart.x_high, most);
  const double x_step = down.size() > 1 ? down[1] - down[0] : 1.0;
  for (const double value : down) {
    if (x_step < 1.0 && value != std::round(value)) continue;
    canvas.fill({std::round(plot.x(value)), plot.rect.bottom(), 1.0F, 5.0F}, theme.axis, 0.0F);
    canvas.text({plot.x(value), plot.rect.bottom() + 16.0F},
                {Type::Caption, theme.text_caption, Align::Centre},
                tick_text(value, std::max(x_step, 1.0)));
  }
  canvas.text({rect.x, plot.rect.y - 18.0F}, {Type::Caption, theme.text_caption, Align::Left},
              chart.y_unit);
  canvas.text({plot.rect.right(), plot.rect.bottom() + 36.0F},
              {Type::Caption, theme.text_caption, Align::Right}, chart.x_name);
}

void draw_mark(Canvas& canvas, const Theme& theme, Point at, const SeriesLook& look,
               bool is_looked_at) {
  const float radius = is_looked_at ? 6.5F : 4.0F;
  canvas.disc(at, radius + 1.5F, theme.card);
  canvas.disc(at, radius, look.color);
  if (is_looked_at) canvas.disc(at, 3.0F, theme.card);
}

void draw_series(Canvas& canvas, const Theme& theme, const Plot& plot, const Series& series,
                 std::optional<std::size_t> looked_at) {
  const SeriesLook look = look_of(theme, series.role);
  if (series.has_line)
    for (const std::vector<Point>& run : line_runs(plot, series.points))
      canvas.polyline(run, look.color, look.thickness);
  if (!series.has_marks) return;
  for (std::size_t number = 0; number < series.points.size(); ++number)
    if (!std::isnan(series.points[number].y))
      draw_mark(canvas, theme, {plot.x(series.points[number].x), plot.y(series.points[number].y)},
                look, looked_at == number);
}

// One entry of the legend, from its right end; returns its width.
float draw_legend_entry(Canvas& canvas, const Theme& theme, Point right, const std::string& name,
                        const SeriesLook& look, const Series* series) {
  const float words = canvas.width_of(Type::Caption, name),
              sample = series == nullptr || series->has_line ? 20.0F : 8.0F;
  canvas.text(right, {Type::Caption, theme.text_secondary, Align::Right}, name);
  const float x = right.x - words - 6.0F - sample;
  if (look.is_dashed)
    canvas.dashes({x, right.y}, {x + sample, right.y}, look.color, 4.0F, 3.0F, 2.0F);
  else if (series != nullptr && series->has_line)
    canvas.fill({x, right.y - 1.5F, sample, 3.0F}, look.color, 1.5F);
  if (series != nullptr && series->has_marks)
    canvas.disc({x + sample / 2.0F, right.y}, 4.0F, look.color);
  return words + 6.0F + sample;
}

void draw_legend(Canvas& canvas, const Theme& theme, const Rect& rect, const LineChart& chart) {
  Point at{rect.right() - end_room, rect.y + 8.0F};
  const auto entry = [&](const std::string& name, const SeriesLook& look, const Series* series) {
    if (!name.empty()) at.x -= draw_legend_entry(canvas, theme, at, name, look, series) + 18.0F;
  };
  if (chart.pass_mark) entry(chart.pass_name, {theme.text_secondary, 1.5F, true}, nullptr);
  for (auto series = chart.series.rbegin(); series != chart.series.rend(); ++series)
    entry(series->name, look_of(theme, series->role), &*series);
}

}  // namespace

Plot plot_of(const Rect& rect, const LineChart& chart) {
  return {{rect.x + axis_room, rect.y + legend_room + unit_room,
           std::max(1.0F, rect.w - axis_room - end_room),
           std::max(1.0F, rect.h - legend_room - unit_room - ticks_room)},
          chart.x_low,
          chart.x_high,
          chart.y_low,
          chart.y_high};
}

void draw_line_chart(Canvas& canvas, const Theme& theme, const Rect& rect, const LineChart& chart) {
  const Plot plot = plot_of(rect, chart);
  draw_legend(canvas, theme, rect, chart);
  draw_axes(canvas, theme, rect, plot, chart);
  if (chart.pass_mark)
    canvas.dashes({plot.rect.x, plot.y(*chart.pass_mark)},
                  {plot.rect.right(), plot.y(*chart.pass_mark)}, theme.text_secondary, 5.0F, 4.0F,
                  1.5F);
  if (chart.looked_at && !chart.series.empty() &&
      *chart.looked_at < chart.series.front().points.size()) {
    const ChartPoint& point = chart.series.front().points[*chart.looked_at];
    const float x = std::round(plot.x(point.x));
    canvas.dashes({x, plot.y(point.y)}, {x, plot.rect.bottom()}, theme.accent, 3.0F, 3.0F, 1.0F);
  }
  for (auto series = chart.series.rbegin(); series != chart.series.rend(); ++series)
    draw_series(canvas, theme, plot, *series,
                &*series == &chart.series.front() ? chart.looked_at : std::nullopt);
}

std::optional<std::size_t> point_near(const Rect& rect, const LineChart& chart, Point place) {
  if (chart.series.empty() || !rect.contains(place)) return std::nullopt;
  const Plot plot = plot_of(rect, chart);
  std::optional<std::size_t> best;
  float best_distance = near_px;
  const std::vector<ChartPoint>& points = chart.series.front().points;
  for (std::size_t number = 0; number < points.size(); ++number) {
    const float distance = std::abs(plot.x(points[number].x) - place.x);
    if (std::isnan(points[number].y) || distance >= best_distance) continue;
    best = number;
    best_distance = distance;
  }
  return best;
}

}  // namespace hallux::ui
