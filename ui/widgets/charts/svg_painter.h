/// Draws a chart as SVG text, for reports.
#pragma once

#include <string>

#include "ui/widgets/charts/painter.h"

namespace hallux::ui {

class SvgPainter : public ChartPainter {
 public:
  /// The picture's size in logical pixels; `ground` fills it.
  SvgPainter(float width, float height, Color ground);

  void fill(const Rect& rect, Color color, float corner) override;
  void polyline(std::span<const Point> points, Color color, float thickness) override;
  void dashes(Point from, Point to, Color color, float on, float off, float thickness) override;
  void band(std::span<const Point> upper, std::span<const Point> lower, Color color) override;
  void disc(Point centre, float radius, Color color) override;
  void polygon(std::span<const Point> points, Color color) override;
  void text(Point at, Type type, Align align, Color color, std::string_view text) override;
  /// An estimate: a file knows no font.
  float width_of(Type type, std::string_view text) const override;

  /// The whole document.
  std::string document() const { return body_ + "</svg>\n"; }

 private:
  std::string body_;
};

}  // namespace hallux::ui
