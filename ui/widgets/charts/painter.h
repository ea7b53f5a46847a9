/// What a chart is drawn with: the screen, an SVG file, later a page of PDF. One chart, the same in all of them.
#pragma once

#include <span>
#include <string_view>

#include "ui/widgets/look/color.h"
#include "ui/widgets/look/geometry.h"
#include "ui/widgets/look/type_scale.h"

namespace hallux::ui {

class ChartPainter {
 public:
  virtual ~ChartPainter() = default;

  virtual void fill(const Rect& rect, Color color, float corner) = 0;
  virtual void polyline(std::span<const Point> points, Color color, float thickness) = 0;
  virtual void dashes(Point from, Point to, Color color, float on, float off, float thickness) = 0;
  /// Between two lines of equally many points.
  virtual void band(std::span<const Point> upper, std::span<const Point> lower, Color color) = 0;
  virtual void disc(Point centre, float radius, Color color) = 0;
  /// needs  the outline is convex
  virtual void polygon(std::span<const Point> points, Color color) = 0;
  /// Capitals centred on at.y.
  virtual void text(Point at, Type type, Align align, Color color, std::string_view text) = 0;
  virtual float width_of(Type type, std::string_view text) const = 0;
};

}  // namespace hallux::ui
