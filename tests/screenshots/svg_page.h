/// One picture as SVG: a light card of its own, so that it reads the same on a white page and on a
/// dark one.
///
/// Places are pixels, x to the right and y down; everything is rounded to hundredths, so the same
/// picture is the same bytes.
#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "simulator/base/vector.h"

namespace hallux::tests {

/// The pictures' classes of lines and texts; their colours are in svg_page.cpp and nowhere else.
///   text   "words" "small" "head", and "number" in a ring
///   lines  "thin" "axis" "cut" "plan" "wall" "dash" "bone"
///   areas  "bonefill" "open" "strip" "pane" "hull"
///   dots   "node" "opennode" "deepnode" "crossing" "corner" "tip"
class SvgPage {
 public:
  /// `title` is what a screen reader says.
  SvgPage(const Vec2& size, std::string_view title);

  /// A class that only this picture has: "b7", "fill:#e8d3a9".
  void add_style(const std::string& name, const std::string& rule) { styles_[name] = rule; }
  /// A path's `d`, in the page's pixels.
  void path(std::string_view d, std::string_view css_class);
  void polygon(std::span<const Vec2> places, std::string_view css_class);
  void polyline(std::span<const Vec2> places, std::string_view css_class);
  void line(const Vec2& from, const Vec2& to, std::string_view css_class);
  /// A line with a head at `to`.
  void arrow(const Vec2& from, const Vec2& to, std::string_view css_class);
  /// A line with a short bar square to it at both ends.
  void measure(const Vec2& from, const Vec2& to);
  void dot(const Vec2& place, double radius, std::string_view css_class);
  /// `anchor` is start, middle or end; `place` lies on the base line.
  void text(const Vec2& place, std::string_view words, std::string_view css_class = "words",
            std::string_view anchor = "start");
  /// Words with a thin line from them to what they name; they end or begin at `from`, whichever is
  /// away from `to`.
  void label(const Vec2& from, const Vec2& to, std::string_view words);
  /// A number in a ring.
  void number(const Vec2& place, std::string_view digits);
  /// A square of the class's colour and what it stands for.
  void key(const Vec2& place, std::string_view css_class, std::string_view words);

  /// What is drawn until the window ends is cut off at its border. Windows do not nest.
  void begin_window(const Vec2& low, const Vec2& size);
  void end_window() { body_ += "</svg>\n"; }

  /// The whole file.
  std::string take() const;

 private:
  Vec2 size_;
  std::string title_, body_;
  std::map<std::string, std::string> styles_;
};

/// Absolute corners as a path's `d`, closed or not.
std::string path_through(std::span<const Vec2> places, bool is_closed);

}  // namespace hallux::tests
