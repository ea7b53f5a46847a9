#include "ui/widgets/charts/svg_painter.h"

#include <cstdio>

namespace hallux::ui {
namespace {

std::string number(float value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f", static_cast<double>(value));
  return text;
}

// name="value" with a space before.
std::string attribute(const char* name, const std::string& value) {
  return std::string(" ") + name + "=\"" + value + "\"";
}

std::string paint(const char* name, Color color) {
  char hex[16];
  std::snprintf(hex, sizeof hex, "#%02X%02X%02X", color.red, color.green, color.blue);
  std::string result = attribute(name, hex);
  if (color.alpha < 255)
    result += attribute((std::string(name) + "-opacity").c_str(),
                        number(static_cast<float>(color.alpha) / 255.0F));
  return result;
}

std::string path(std::span<const Point> points) {
  std::string result;
  for (const Point& point : points)
    result += (result.empty() ? "" : " ") + number(point.x) + "," + number(point.y);
  return result;
}

std::string escaped(std::string_view text) {
  std::string result;
  for (const char letter : text) {
    if (letter == '&')
      result += "&amp;";
    else if (letter == '<')
      result += "&lt;";
    else if (letter == '>')
      result += "&gt;";
    else
      result += letter;
  }
  return result;
}

float em_of(Type type) {
  switch (type) {
    case Type::Caption:
    case Type::CaptionMedium:
      return 12.4F;
    case Type::Small:
    case Type::SmallMedium:
      return 13.2F;
    case Type::CardTitle:
      return 15.7F;
    case Type::Section:
      return 19.8F;
    case Type::Title:
      return 26.4F;
    case Type::Number:
      return 29.8F;
    case Type::Score:
      return 47.9F;
    case Type::Body:
    case Type::BodyMedium:
    case Type::BodyStrong:
      break;
  }
  return 14.0F;
}

const char* anchor_of(Align align) {
  return align == Align::Left ? "start" : align == Align::Centre ? "middle" : "end";
}

}  // namespace

SvgPainter::SvgPainter(float width, float height, Color ground) {
  body_ = "<svg xmlns=\"http://www.w3.org/2000/svg\"" +
          attribute("viewBox", "0 0 " + number(width) + " " + number(height)) +
          attribute("font-family", "Inter, 'DejaVu Sans', sans-serif") + ">\n";
  fill({0.0F, 0.0F, width, height}, ground, 0.0F);
}

void SvgPainter::fill(const Rect& rect, Color color, float corner) {
  body_ += "<rect" + attribute("x", number(rect.x)) + attribute("y", number(rect.y)) +
           attribute("width", number(rect.w)) + attribute("height", number(rect.h)) +
           attribute("rx", number(corner)) + paint("fill", color) + "/>\n";
}

void SvgPainter::polyline(std::span<const Point> points, Color color, float thickness) {
  body_ += "<polyline" + attribute("points", path(points)) + attribute("fill", "none") +
           paint("stroke", color) + attribute("stroke-width", number(thickness)) + "/>\n";
}

void SvgPainter::dashes(Point from, Point to, Color color, float on, float off, float thickness) {
  body_ += "<line" + attribute("x1", number(from.x)) + attribute("y1", number(from.y)) +
           attribute("x2", number(to.x)) + attribute("y2", number(to.y)) + paint("stroke", color) +
           attribute("stroke-width", number(thickness)) +
           attribute("stroke-dasharray", number(on) + " " + number(off)) + "/>\n";
}

void SvgPainter::band(std::span<const Point> upper, std::span<const Point> lower, Color color) {
  std::vector<Point> outline(upper.begin(), upper.end());
  outline.insert(outline.end(), lower.rbegin(), lower.rend());
  polygon(outline, color);
}

void SvgPainter::disc(Point centre, float radius, Color color) {
  body_ += "<circle" + attribute("cx", number(centre.x)) + attribute("cy", number(centre.y)) +
           attribute("r", number(radius)) + paint("fill", color) + "/>\n";
}

void SvgPainter::polygon(std::span<const Point> points, Color color) {
  body_ += "<polygon" + attribute("points", path(points)) + paint("fill", color) + "/>\n";
}

void SvgPainter::text(Point at, Type type, Align align, Color color, std::string_view text) {
  const float em = em_of(type), baseline = at.y + 0.727F * em / 2.0F;
  body_ += "<text" + attribute("x", number(at.x)) + attribute("y", number(baseline)) +
           attribute("font-size", number(em)) + attribute("text-anchor", anchor_of(align)) +
           paint("fill", color) + ">" + escaped(text) + "</text>\n";
}

float SvgPainter::width_of(Type type, std::string_view text) const {
  std::size_t letters = 0;
  for (const char letter : text)
    if ((static_cast<unsigned char>(letter) & 0xC0U) != 0x80U) ++letters;
  return static_cast<float>(letters) * em_of(type) * 0.56F;
}

}  // namespace hallux::ui
