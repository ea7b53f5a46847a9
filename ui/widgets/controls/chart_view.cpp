#include "ui/widgets/controls/chart_view.h"

#include <cmath>

#include "ui/widgets/controls/tooltip.h"
#include "ui/widgets/shapes.h"

namespace hallux::ui {

std::optional<std::size_t> line_chart(Ui& ui, std::string_view id, const Rect& rect,
                                      LineChart chart, const PointWords& words) {
  std::optional<std::size_t> pressed, focused;
  const Plot plot = plot_of(rect, chart);
  if (!chart.series.empty()) {
    const std::vector<ChartPoint>& points = chart.series.front().points;
    for (std::size_t number = 0; number < points.size(); ++number) {
      if (std::isnan(points[number].y)) continue;
      const Response response =
          ui.control({.id = std::string(id) + "." + std::to_string(number),
                      .label = words(number).first,
                      .rect = {plot.x(points[number].x) - 10.0F, plot.y(points[number].y) - 10.0F,
                               20.0F, 20.0F},
                      .role = Role::Option,
                      .group = std::string(id),
                      .is_in_sequence = true});
      if (response.shows_ring) focused = number;
      if (response.is_pressed()) pressed = number;
    }
  }
  chart.looked_at = point_near(rect, chart, ui.pointer());
  if (focused) chart.looked_at = focused;
  draw_line_chart(ui.canvas(), ui.theme(), rect, chart);
  if (chart.looked_at) {
    const ChartPoint& point = chart.series.front().points[*chart.looked_at];
    const Point place{plot.x(point.x), plot.y(point.y)};
    const auto [value, context] = words(*chart.looked_at);
    tooltip(ui, place, value, context);
    if (focused)
      draw_focus_ring(ui.canvas(), ui.theme(), {place.x - 7.0F, place.y - 7.0F, 14.0F, 14.0F},
                      7.0F);
  }
  return pressed;
}

}  // namespace hallux::ui
