/// Text and numbers inside HTML and SVG. Inside this corner only.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "simulator/base/vector.h"

namespace hallux::ui {

/// Safe between tags and inside quoted attributes; bytes that no text may hold become U+FFFD.
std::string escaped(std::string_view text);
/// A coordinate: at most two decimals, no needless zeros.
std::string coordinate(double value);

/// The extent of what is drawn, grown point by point.
struct PictureBox {
  Vec2 min_mm{1.0e9, 1.0e9}, max_mm{-1.0e9, -1.0e9};

  void include(const Vec2& point_mm) noexcept;
  void include(const std::vector<std::vector<Vec2>>& outlines) noexcept;
  /// The square around it with room on every side for five lines of text.
  PictureBox square() const noexcept;
  /// The height of a letter, so that text is equally large in every square picture.
  double text_mm() const noexcept;
  bool meets(const std::vector<Vec2>& outline) const noexcept;
  bool is_empty() const noexcept { return min_mm.x > max_mm.x; }
  Vec2 size_mm() const noexcept { return max_mm - min_mm; }
};

/// Closed outlines as one path; up is positive in millimetres and negative on the page.
std::string outline_path(const std::vector<std::vector<Vec2>>& outlines);
/// A text with a class at a place of the picture; `anchor` is start, middle or end.
std::string svg_text(const Vec2& place, std::string_view anchor, std::string_view css_class,
                     std::string_view text);
/// The opening tag of a square picture that shows `box`.
std::string svg_square(const PictureBox& box, std::string_view label);
std::string svg_dot(const Vec2& place, double radius);
std::string svg_line(const Vec2& from, const Vec2& to, std::string_view css_class);

}  // namespace hallux::ui
