#include "ui/report/face_svg.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "assessment/number_text.h"
#include "ui/report/html_text.h"

namespace hallux::ui {

namespace {

/// Steps of the diverging map on either side of the neutral middle.
constexpr int half_steps = 5;
/// The map never spans less than this: a cut within a tenth must not look like a rainbow.
constexpr double span_min_mm = 1.0, span_max_mm = 3.0;

double span_of(const FacePicture& picture) {
  double greatest_mm = span_min_mm;
  for (const FaceDot& dot : picture.dots) {
    greatest_mm = std::max(greatest_mm, std::abs(dot.deviation_mm));
  }
  return std::min(span_max_mm, std::ceil(greatest_mm * 2.0) / 2.0);
}

int step_of(double deviation_mm, double span_mm) {
  const double part = std::clamp(deviation_mm / span_mm, -1.0, 1.0);
  return static_cast<int>(std::lround(part * half_steps));
}

std::string mix(const std::array<int, 3>& from, const std::array<int, 3>& to, double part) {
  std::string text = "rgb(";
  for (std::size_t channel = 0; channel < 3; ++channel) {
    const double value = from[channel] + part * (to[channel] - from[channel]);
    text += (channel == 0 ? "" : ",") + std::to_string(std::lround(value));
  }
  return text + ")";
}

/// Okabe and Ito's blue and vermilion over a warm white: told apart with any colour vision.
std::string colour_of(int step) {
  constexpr std::array<int, 3> blue{0, 114, 178}, middle{242, 240, 232}, vermilion{213, 94, 0};
  const double part = std::abs(step) / static_cast<double>(half_steps);
  return mix(middle, step < 0 ? blue : vermilion, part);
}

/// One path for each colour: a square for every sample.
std::string dots_svg(const FacePicture& picture, double span_mm) {
  std::map<int, std::string> paths;
  // A little overlap hides the seams between squares.
  const double size = 1.08 * picture.dot_mm;
  for (const FaceDot& dot : picture.dots) {
    paths[step_of(dot.deviation_mm, span_mm)] += "M" + coordinate(dot.place_mm.x - 0.5 * size) +
                                                 " " + coordinate(-dot.place_mm.y - 0.5 * size) +
                                                 "h" + coordinate(size) + "v" + coordinate(size) +
                                                 "h" + coordinate(-size) + "z";
  }
  std::string svg;
  for (const auto& [step, path] : paths) {
    svg += "<path d=\"" + path + "\" fill=\"" + colour_of(step) + "\"/>";
  }
  return svg;
}

std::string landmark_svg(const NamedPoint& point, double text_mm) {
  const Vec2 place{point.place_mm.x, -point.place_mm.y};
  return svg_dot(place, 0.35 * text_mm) +
         svg_text(place - Vec2{0.0, 0.8 * text_mm}, "middle", "mm", point.name);
}

/// Steps of colour along the lower edge, named at both ends and in the middle.
std::string legend_svg(const FacePicture& picture, double span_mm, const PictureBox& box) {
  const double text_mm = box.text_mm();
  const double width = 0.6 * box.size_mm().x;
  const double left = box.min_mm.x + 0.2 * box.size_mm().x;
  const double top = -box.min_mm.y - 2.6 * text_mm;
  const int steps = 2 * half_steps + 1;
  std::string svg;
  for (int step = -half_steps; step <= half_steps; ++step) {
    svg += "<rect x=\"" + coordinate(left + (step + half_steps) * width / steps) + "\" y=\"" +
           coordinate(top) + "\" width=\"" + coordinate(width / steps + 0.02) + "\" height=\"" +
           coordinate(0.8 * text_mm) + "\" fill=\"" + colour_of(step) + "\"/>";
  }
  const std::string span = assessment::short_number_text(span_mm) + " mm ";
  const double below = top + 2.1 * text_mm;
  svg += svg_text(Vec2{left, below}, "middle", "mm", "\xE2\x88\x92" + span + picture.below);
  svg += svg_text(Vec2{left + 0.5 * width, below}, "middle", "mm", "0");
  return svg + svg_text(Vec2{left + width, below}, "middle", "mm", "+" + span + picture.above);
}

std::string axes_svg(const FacePicture& picture, const PictureBox& box) {
  const double text_mm = box.text_mm();
  const Vec2 middle{0.5 * (box.min_mm.x + box.max_mm.x), -0.5 * (box.min_mm.y + box.max_mm.y)};
  return svg_text(Vec2{middle.x, -box.max_mm.y + 1.4 * text_mm}, "middle", "mm axis", picture.up) +
         svg_text(Vec2{box.max_mm.x - 0.3 * text_mm, middle.y}, "end", "mm axis", picture.right);
}

/// Around what was cut and the landmarks; where nothing was cut, around the whole planned section.
PictureBox box_of(const FacePicture& picture) {
  PictureBox box;
  for (const FaceDot& dot : picture.dots) box.include(dot.place_mm);
  for (const NamedPoint& point : picture.landmarks) box.include(point.place_mm);
  if (picture.dots.empty()) box.include(picture.planned_outlines);
  return box;
}

}  // namespace

std::string face_svg(const FacePicture& picture) {
  const PictureBox content = box_of(picture);
  if (content.is_empty()) return "";
  const PictureBox box = content.square();
  const double span_mm = span_of(picture);
  std::vector<std::vector<Vec2>> outlines;
  for (const std::vector<Vec2>& outline : picture.planned_outlines) {
    if (content.meets(outline)) outlines.push_back(outline);
  }
  std::string svg = svg_square(box, "The face seen square on");
  svg += dots_svg(picture, span_mm);
  svg += "<path d=\"" + outline_path(outlines) + "\" class=\"plan\"/>";
  for (const NamedPoint& point : picture.landmarks) svg += landmark_svg(point, box.text_mm());
  return svg + axes_svg(picture, box) + legend_svg(picture, span_mm, box) + "</svg>";
}

}  // namespace hallux::ui
