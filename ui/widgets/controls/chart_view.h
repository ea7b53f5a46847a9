/// Charts on the screen: drawn with the canvas, pointed at with the mouse, walked along with the arrows.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "ui/widgets/charts/line_chart.h"
#include "ui/widgets/charts/timeline.h"
#include "ui/widgets/ui.h"

namespace hallux::ui {

/// Draws charts on a canvas.
class CanvasPainter : public ChartPainter {
 public:
  explicit CanvasPainter(Canvas& canvas) : canvas_(canvas) {}

  void fill(const Rect& rect, Color color, float corner) override;
  void polyline(std::span<const Point> points, Color color, float thickness) override;
  void dashes(Point from, Point to, Color color, float on, float off, float thickness) override;
  void band(std::span<const Point> upper, std::span<const Point> lower, Color color) override;
  void disc(Point centre, float radius, Color color) override;
  void polygon(std::span<const Point> points, Color color) override;
  void text(Point at, Type type, Align align, Color color, std::string_view text) override;
  float width_of(Type type, std::string_view text) const override;

 private:
  Canvas& canvas_;
};

/// What a tooltip says about a point: the value, and attempt, date and the like below it.
using PointWords = std::function<std::pair<std::string, std::string>(std::size_t point)>;

/// Shows the chart; the point under the pointer, or the one the arrows walked to, is drawn large with a tooltip. Each
/// point is a control `id.0`, `id.1` ... Returns the point that was pressed.
std::optional<std::size_t> line_chart(Ui& ui, std::string_view id, const Rect& rect,
                                      LineChart chart, const PointWords& words);

/// Shows the timeline as the area `id`. Returns the moment that the pointer was pressed or dragged to.
std::optional<double> timeline(Ui& ui, std::string_view id, const Rect& rect,
                               const Timeline& timeline);

}  // namespace hallux::ui
