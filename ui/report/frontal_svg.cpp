#include "ui/report/frontal_svg.h"

#include "ui/report/html_text.h"

namespace hallux::ui {

namespace {

Vec2 on_page(const Vec2& place_mm) noexcept { return Vec2{place_mm.x, -place_mm.y}; }

std::string words_svg(const PictureBox& box) {
  const double text_mm = box.text_mm();
  const double side = 0.3 * text_mm;
  const Vec2 middle{0.5 * (box.min_mm.x + box.max_mm.x), -0.5 * (box.min_mm.y + box.max_mm.y)};
  return svg_text(Vec2{middle.x, -box.max_mm.y + 1.4 * text_mm}, "middle", "mm axis", "dorsal") +
         svg_text(Vec2{middle.x, -box.min_mm.y - 3.2 * text_mm}, "middle", "mm axis", "plantar") +
         svg_text(Vec2{box.min_mm.x + side, middle.y}, "start", "mm axis", "medial") +
         svg_text(Vec2{box.max_mm.x - side, middle.y}, "end", "mm axis", "lateral");
}

/// A stroke of the line and its name.
std::string key_svg(const Vec2& place, double text_mm, const char* css_class, const char* text) {
  const Vec2 line = place - Vec2{0.0, 0.35 * text_mm};
  return svg_line(line, line + Vec2{2.4 * text_mm, 0.0}, css_class) +
         svg_text(place + Vec2{3.0 * text_mm, 0.0}, "start", "mm", text);
}

std::string keys_svg(const PictureBox& box, bool has_actual) {
  const double text_mm = box.text_mm();
  const Vec2 left{box.min_mm.x + 5.0 * text_mm, -box.min_mm.y - 0.6 * text_mm};
  std::string svg = key_svg(left, text_mm, "plan", "planned face");
  if (!has_actual) return svg;
  return svg + key_svg(left + Vec2{13.0 * text_mm, 0.0}, text_mm, "cut", "your face");
}

}  // namespace

std::string frontal_svg(const FrontalPicture& picture) {
  PictureBox content;
  content.include(picture.outlines);
  content.include(picture.planned.from_mm);
  content.include(picture.planned.to_mm);
  const PictureBox box = content.square();
  const Vec2 landmark = on_page(picture.landmark.place_mm);
  std::string svg = svg_square(box, "Section across the bone");
  svg += "<path d=\"" + outline_path(picture.outlines) + "\" class=\"bone\"/>";
  if (picture.actual) {
    svg += svg_line(on_page(picture.actual->from_mm), on_page(picture.actual->to_mm), "cut");
  }
  svg += svg_line(on_page(picture.planned.from_mm), on_page(picture.planned.to_mm), "plan");
  svg += svg_dot(landmark, 0.35 * box.text_mm());
  svg += svg_text(landmark + Vec2{0.9 * box.text_mm(), 0.35 * box.text_mm()}, "start", "mm",
                  picture.landmark.name);
  return svg + words_svg(box) + keys_svg(box, picture.actual.has_value()) + "</svg>";
}

}  // namespace hallux::ui
