#include "ui/report/html_text.h"

#include <algorithm>
#include <cmath>

#include "assessment/number_text.h"

namespace hallux::ui {

namespace {

/// A picture is shown about 400 px wide and its text 13 px high; five lines of it fit into either
/// margin.
constexpr double text_share = 13.0 / 400.0;
constexpr double content_share = 1.0 - 10.0 * text_share;

}  // namespace

std::string escaped(std::string_view text) {
  std::string safe;
  for (const char letter : text) {
    const bool is_control =
        static_cast<unsigned char>(letter) < 0x20 && letter != '\n' && letter != '\t';
    if (is_control) {
      safe += "\xEF\xBF\xBD";
    } else if (letter == '&') {
      safe += "&amp;";
    } else if (letter == '<') {
      safe += "&lt;";
    } else if (letter == '>') {
      safe += "&gt;";
    } else if (letter == '"') {
      safe += "&quot;";
    } else if (letter == '\'') {
      safe += "&#39;";
    } else {
      safe += letter;
    }
  }
  return safe;
}

std::string coordinate(double value) {
  return assessment::short_number_text(std::round(value * 100.0) / 100.0);
}

void PictureBox::include(const Vec2& point_mm) noexcept {
  min_mm = Vec2{std::min(min_mm.x, point_mm.x), std::min(min_mm.y, point_mm.y)};
  max_mm = Vec2{std::max(max_mm.x, point_mm.x), std::max(max_mm.y, point_mm.y)};
}

void PictureBox::include(const std::vector<std::vector<Vec2>>& outlines) noexcept {
  for (const std::vector<Vec2>& outline : outlines) {
    for (const Vec2& point : outline) include(point);
  }
}

PictureBox PictureBox::square() const noexcept {
  const double half = 0.5 * std::max(size_mm().x, size_mm().y) / content_share;
  const Vec2 middle = 0.5 * (min_mm + max_mm);
  return {middle - Vec2{half, half}, middle + Vec2{half, half}};
}

double PictureBox::text_mm() const noexcept { return size_mm().x * text_share; }

bool PictureBox::meets(const std::vector<Vec2>& outline) const noexcept {
  PictureBox other;
  for (const Vec2& point : outline) other.include(point);
  return other.min_mm.x <= max_mm.x && other.max_mm.x >= min_mm.x && other.min_mm.y <= max_mm.y &&
         other.max_mm.y >= min_mm.y;
}

std::string outline_path(const std::vector<std::vector<Vec2>>& outlines) {
  std::string path;
  for (const std::vector<Vec2>& outline : outlines) {
    char command = 'M';
    for (const Vec2& point : outline) {
      path += command + coordinate(point.x) + " " + coordinate(-point.y);
      command = 'L';
    }
    if (!outline.empty()) path += "Z";
  }
  return path;
}

std::string svg_text(const Vec2& place, std::string_view anchor, std::string_view css_class,
                     std::string_view text) {
  return "<text x=\"" + coordinate(place.x) + "\" y=\"" + coordinate(place.y) +
         "\" text-anchor=\"" + std::string(anchor) + "\" class=\"" + std::string(css_class) +
         "\">" + escaped(text) + "</text>";
}

std::string svg_square(const PictureBox& box, std::string_view label) {
  return "<svg class=\"picture\" role=\"img\" aria-label=\"" + escaped(label) + "\" viewBox=\"" +
         coordinate(box.min_mm.x) + " " + coordinate(-box.max_mm.y) + " " +
         coordinate(box.size_mm().x) + " " + coordinate(box.size_mm().y) +
         "\" style=\"font-size:" + coordinate(box.text_mm()) + "px\">";
}

std::string svg_dot(const Vec2& place, double radius) {
  return "<circle cx=\"" + coordinate(place.x) + "\" cy=\"" + coordinate(place.y) + "\" r=\"" +
         coordinate(radius) + "\" class=\"landmark\"/>";
}

std::string svg_line(const Vec2& from, const Vec2& to, std::string_view css_class) {
  return "<line x1=\"" + coordinate(from.x) + "\" y1=\"" + coordinate(from.y) + "\" x2=\"" +
         coordinate(to.x) + "\" y2=\"" + coordinate(to.y) + "\" class=\"" + std::string(css_class) +
         "\"/>";
}

}  // namespace hallux::ui
