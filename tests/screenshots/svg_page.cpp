#include "tests/screenshots/svg_page.h"

#include <cmath>

#include "ui/report/html_text.h"

namespace hallux::tests {

namespace {

using ui::coordinate;
using ui::escaped;

/// Warm bone, one blue for what the kerf opens, vermilion for the front: told apart with any colour
/// vision.
constexpr std::string_view common_styles =
    "text{font-family:Helvetica,Arial,'Liberation Sans',sans-serif;fill:#2b2b2b;paint-order:stroke;"
    "stroke:#fdfcf9;stroke-width:3px;stroke-linejoin:round}"
    ".words{font-size:13px}.small{font-size:11.5px;fill:#555}.head{font-size:13px;font-weight:bold}"
    ".digits{font-size:11px;font-weight:bold;stroke:none}"
    "path,line,circle{stroke-linejoin:round;stroke-linecap:round}"
    ".thin{fill:none;stroke:#6b6b6b;stroke-width:.7}"
    ".axis{fill:none;stroke:#2b2b2b;stroke-width:1.5}.axishead{fill:#2b2b2b}"
    ".cut{fill:none;stroke:#d55e00;stroke-width:1.8}.cuthead{fill:#d55e00}"
    ".plan{fill:none;stroke:#2b2b2b;stroke-width:1.2;stroke-dasharray:6 4}"
    ".wall{fill:none;stroke:#0067a8;stroke-width:1.6}.wallhead{fill:#0067a8}"
    ".dash{fill:none;stroke:#0067a8;stroke-width:1;stroke-dasharray:4 3}"
    ".bone{fill:none;stroke:#8a6a35;stroke-width:1.3}.bonehead{fill:#8a6a35}"
    ".frame{fill:none;stroke:#d9d4c8;stroke-width:1}"
    ".grid{fill:none;stroke:#dcd8cf;stroke-width:.6}"
    ".bonefill{fill:#f0e2c6;fill-rule:evenodd;stroke:none}"
    ".open{fill:#0067a8;fill-opacity:.16;stroke:none}"
    ".strip{fill:#e2b266;stroke:#8a6a35;stroke-width:.35}"
    ".pane{fill:#0067a8;fill-opacity:.13;stroke:#0067a8;stroke-width:.9}"
    ".hull{fill:#d55e00;fill-opacity:.08;stroke:none}"
    ".node{fill:#fdfcf9;stroke:#8d8d8d;stroke-width:.9}"
    ".opennode{fill:#7db6dc;stroke:#0067a8;stroke-width:.9}"
    ".deepnode{fill:#0067a8;stroke:#0067a8;stroke-width:.9}"
    ".crossing{fill:#fdfcf9;stroke:#d55e00;stroke-width:1.3}"
    ".corner{fill:#d55e00;stroke:#fdfcf9;stroke-width:.8}"
    ".tip{fill:#d55e00;stroke:none}.far{fill:#8a6a35;stroke:none}"
    ".rim{fill:none;stroke:#3a3020;stroke-width:.6}"
    ".ring{fill:#fdfcf9;stroke:#2b2b2b;stroke-width:1}";

}  // namespace

SvgPage::SvgPage(const Vec2& size, std::string_view title) : size_(size), title_(title) {}

std::string path_through(std::span<const Vec2> places, bool is_closed) {
  std::string d;
  char command = 'M';
  for (const Vec2& place : places) {
    d += command + coordinate(place.x) + " " + coordinate(place.y);
    command = 'L';
  }
  return is_closed ? d + "z" : d;
}

void SvgPage::path(std::string_view d, std::string_view css_class) {
  body_ += "<path class=\"" + std::string(css_class) + "\" d=\"" + std::string(d) + "\"/>\n";
}

void SvgPage::polygon(std::span<const Vec2> places, std::string_view css_class) {
  path(path_through(places, true), css_class);
}

void SvgPage::polyline(std::span<const Vec2> places, std::string_view css_class) {
  path(path_through(places, false), css_class);
}

void SvgPage::line(const Vec2& from, const Vec2& to, std::string_view css_class) {
  body_ += ui::svg_line(from, to, css_class) + "\n";
}

void SvgPage::arrow(const Vec2& from, const Vec2& to, std::string_view css_class) {
  const Vec2 way = to - from;
  const Vec2 along = way / std::sqrt(glm::dot(way, way));
  const Vec2 across(-along.y, along.x);
  line(from, to - 6.0 * along, css_class);
  const std::array<Vec2, 3> head{to, to - 9.0 * along + 3.6 * across,
                                 to - 9.0 * along - 3.6 * across};
  polygon(head, std::string(css_class) + "head");
}

void SvgPage::measure(const Vec2& from, const Vec2& to) {
  const Vec2 way = to - from;
  const Vec2 across = 4.0 * Vec2(-way.y, way.x) / std::sqrt(glm::dot(way, way));
  line(from, to, "axis");
  line(from - across, from + across, "axis");
  line(to - across, to + across, "axis");
}

void SvgPage::dot(const Vec2& place, double radius, std::string_view css_class) {
  body_ += "<circle class=\"" + std::string(css_class) + "\" cx=\"" + coordinate(place.x) +
           "\" cy=\"" + coordinate(place.y) + "\" r=\"" + coordinate(radius) + "\"/>\n";
}

void SvgPage::text(const Vec2& place, std::string_view words, std::string_view css_class,
                   std::string_view anchor) {
  body_ += ui::svg_text(place, anchor, css_class, words) + "\n";
}

void SvgPage::label(const Vec2& from, const Vec2& to, std::string_view words) {
  const bool is_left = to.x > from.x;
  line(from + Vec2(is_left ? 4.0 : -4.0, -4.0), to, "thin");
  text(from, words, "words", is_left ? "end" : "start");
}

void SvgPage::number(const Vec2& place, std::string_view digits) {
  dot(place, 8.0, "ring");
  text(place + Vec2(0.0, 4.0), digits, "digits", "middle");
}

void SvgPage::key(const Vec2& place, std::string_view css_class, std::string_view words) {
  const std::array<Vec2, 4> square{place, place + Vec2(12.0, 0.0), place + Vec2(12.0, 12.0),
                                   place + Vec2(0.0, 12.0)};
  polygon(square, css_class);
  text(place + Vec2(18.0, 10.5), words);
}

void SvgPage::begin_window(const Vec2& low, const Vec2& size) {
  const std::string x = coordinate(low.x), y = coordinate(low.y);
  const std::string width = coordinate(size.x), height = coordinate(size.y);
  body_ += "<svg x=\"" + x + "\" y=\"" + y + "\" width=\"" + width + "\" height=\"" + height +
           "\" viewBox=\"" + x + " " + y + " " + width + " " + height + "\">\n";
}

std::string SvgPage::take() const {
  const std::string width = coordinate(size_.x), height = coordinate(size_.y);
  std::string svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + width + "\" height=\"" +
                    height + "\" viewBox=\"0 0 " + width + " " + height +
                    "\" role=\"img\">\n<title>" + escaped(title_) + "</title>\n<style>" +
                    std::string(common_styles);
  for (const auto& [name, rule] : styles_) {
    svg.append(".").append(name).append("{").append(rule).append("}");
  }
  svg += "</style>\n<rect x=\".5\" y=\".5\" width=\"" + coordinate(size_.x - 1.0) + "\" height=\"" +
         coordinate(size_.y - 1.0) + "\" rx=\"8\" fill=\"#fdfcf9\" stroke=\"#d9d4c8\"/>\n";
  return svg + body_ + "</svg>\n";
}

}  // namespace hallux::tests
