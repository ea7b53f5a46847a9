// Drawing in logical pixels on ImGui's list. Edges are rounded to device pixels after scaling,
// lines take whole ones: so nothing is blurred at 1.25 or 1.5. Every text is noted with the room it
// had, which lets a test find words that are cut off. Layers are channels of one list, joined at
// the end.
#include "ui/widgets/canvas.h"

#include <imgui.h>

#include <bit>
#include <cmath>
#include <numbers>

#include "ui/widgets/look/code_box.h"
#include "ui/widgets/texts/text_layout.h"

namespace hallux::ui {
namespace {

ImDrawFlags flags_of(Corners corners) {
  if (corners == Corners::Top) return ImDrawFlags_RoundCornersTop;
  if (corners == Corners::Bottom) return ImDrawFlags_RoundCornersBottom;
  return corners == Corners::None ? ImDrawFlags_RoundCornersNone : ImDrawFlags_RoundCornersAll;
}

// A thickness in whole device pixels, at least one.
float whole(float thickness) { return std::max(1.0F, std::round(thickness)); }

}  // namespace

Canvas::Canvas(ImDrawList& list, const FontAtlas& fonts, FrameContent& content, const Rect& display)
    : list_(&list),
      fonts_(&fonts),
      content_(&content),
      scale_(fonts.scale()),
      clips_{display},
      rooms_{display} {
  list_->ChannelsSplit(layer_count);
  list_->ChannelsSetCurrent(0);
}

unsigned Canvas::packed(Color color) const noexcept {
  const auto alpha =
      static_cast<unsigned>(std::lround(presence_ * static_cast<float>(color.alpha)));
  return IM_COL32(color.red, color.green, color.blue, alpha);
}

float Canvas::device(float logical) const noexcept { return std::round(logical * scale_); }

void Canvas::fill(const Rect& rect, Color color, float radius, Corners corners) {
  if (color.alpha == 0 || rect.is_empty()) return;
  list_->AddRectFilled({device(rect.x), device(rect.y)},
                       {device(rect.right()), device(rect.bottom())}, packed(color),
                       radius * scale_, flags_of(corners));
}

void Canvas::outline(const Rect& rect, Color color, float radius, float thickness) {
  if (color.alpha == 0 || rect.is_empty()) return;
  const float width = whole(thickness * scale_), in = (width - 1.0F) / 2.0F;
  list_->AddRect({device(rect.x) + in, device(rect.y) + in},
                 {device(rect.right()) - in, device(rect.bottom()) - in}, packed(color),
                 std::max(0.0F, radius * scale_ - in), 0, width);
}

void Canvas::hairline_across(float x, float y, float width, Color color) {
  const float top = device(y);
  list_->AddRectFilled({device(x), top}, {device(x + width), top + whole(scale_)}, packed(color));
}

void Canvas::hairline_down(float x, float y, float height, Color color) {
  const float left = device(x);
  list_->AddRectFilled({left, device(y)}, {left + whole(scale_), device(y + height)},
                       packed(color));
}

void Canvas::disc(Point centre, float radius, Color color) {
  list_->AddCircleFilled({centre.x * scale_, centre.y * scale_}, radius * scale_, packed(color));
}

void Canvas::ring(Point centre, float radius, Color color, float thickness) {
  list_->AddCircle({centre.x * scale_, centre.y * scale_}, radius * scale_, packed(color), 0,
                   thickness * scale_);
}

void Canvas::arc(Point centre, float radius, float from_rad, float to_rad, Color color,
                 float thickness, bool round_ends) {
  const float device_radius = radius * scale_;
  const int segments = static_cast<int>(8.0F + std::abs(to_rad - from_rad) * device_radius / 2.0F);
  list_->PathArcTo({centre.x * scale_, centre.y * scale_}, device_radius, from_rad, to_rad,
                   segments);
  list_->PathStroke(packed(color), 0, thickness * scale_);
  if (!round_ends) return;
  for (const float angle : {from_rad, to_rad})
    disc({centre.x + std::cos(angle) * radius, centre.y + std::sin(angle) * radius},
         thickness / 2.0F - 0.25F / scale_, color);
}

void Canvas::line(Point from, Point to, Color color, float thickness) {
  const Point points[] = {from, to};
  polyline(points, color, thickness);
}

void Canvas::polyline(std::span<const Point> points, Color color, float thickness) {
  std::vector<ImVec2> path;
  for (const Point& point : points) {
    const ImVec2 at{point.x * scale_, point.y * scale_};
    if (path.empty() || std::hypot(at.x - path.back().x, at.y - path.back().y) > 0.05F)
      path.push_back(at);
  }
  if (path.size() < 2) return;
  list_->AddPolyline(path.data(), static_cast<int>(path.size()), packed(color), 0,
                     thickness * scale_);
}

void Canvas::polygon(std::span<const Point> points, Color color) {
  std::vector<ImVec2> path;
  for (const Point& point : points) path.push_back({point.x * scale_, point.y * scale_});
  list_->AddConvexPolyFilled(path.data(), static_cast<int>(path.size()), packed(color));
}

void Canvas::dashes(Point from, Point to, Color color, float on, float off, float thickness) {
  const float length = std::hypot(to.x - from.x, to.y - from.y);
  if (length <= 0.0F) return;
  const float dx = (to.x - from.x) / length, dy = (to.y - from.y) / length;
  for (float start = 0.0F; start < length; start += on + off) {
    const float end = std::min(start + on, length);
    const Point a{from.x + start * dx, from.y + start * dy},
        b{from.x + end * dx, from.y + end * dy};
    const float width = whole(thickness * scale_) / scale_;
    if (dy == 0.0F)
      fill({a.x, a.y - width / 2.0F, b.x - a.x, width}, color);
    else if (dx == 0.0F)
      fill({a.x - width / 2.0F, std::min(a.y, b.y), width, std::abs(b.y - a.y)}, color);
    else
      line(a, b, color, thickness);
  }
}

void Canvas::gradient_across(const Rect& rect, Color left, Color right) {
  list_->AddRectFilledMultiColor({device(rect.x), device(rect.y)},
                                 {device(rect.right()), device(rect.bottom())}, packed(left),
                                 packed(right), packed(right), packed(left));
}

void Canvas::picture(const Picture& picture, const Rect& rect, float radius, Corners corners) {
  if (picture.texture == 0) return;
  const float top = picture.is_upside_down ? 1.0F : 0.0F;
  list_->AddImageRounded(std::bit_cast<ImTextureID>(static_cast<std::uintptr_t>(picture.texture)),
                         {device(rect.x), device(rect.y)},
                         {device(rect.right()), device(rect.bottom())}, {0.0F, top},
                         {1.0F, 1.0F - top}, 0xFFFFFFFFU, radius * scale_, flags_of(corners));
}

float Canvas::width_of(Type type, std::string_view text) const noexcept {
  return text_width(fonts_->face(type), text) / scale_;
}

void Canvas::draw_glyphs(const FontFace& face, float pen, float baseline, Color color,
                         std::string_view text) {
  for (std::size_t place = 0; place < text.size();) {
    const char32_t letter = next_code_point(text, place);
    const Glyph& glyph = face.glyph(letter);
    if (glyph.is_box) {
      draw_code_box(face, {std::round(pen), baseline}, color, letter);
    } else if (glyph.is_visible) {
      const float x = std::round(pen);
      list_->PrimReserve(6, 4);
      list_->PrimRectUV({x + glyph.left, baseline + glyph.top},
                        {x + glyph.right, baseline + glyph.bottom}, {glyph.u0, glyph.v0},
                        {glyph.u1, glyph.v1}, packed(color));
    }
    pen += glyph.advance;
  }
}

/// Centred in height on the capitals beside it.
void Canvas::draw_code_box(const FontFace& face, Point pen, Color color, char32_t letter) {
  const auto pixel = static_cast<float>(code_box_pixel(face.size()));
  const float left = pen.x + pixel;
  const float top =
      std::round(pen.y - (face.cap_height() + pixel * static_cast<float>(code_box_height)) / 2.0F);
  const std::vector<CodeBoxPart> parts = code_box_parts(letter);
  const auto count = static_cast<int>(parts.size());
  list_->PrimReserve(6 * count, 4 * count);
  for (const CodeBoxPart& part : parts) {
    const float x = left + pixel * static_cast<float>(part.x),
                y = top + pixel * static_cast<float>(part.y);
    list_->PrimRect(
        {x, y},
        {x + pixel * static_cast<float>(part.width), y + pixel * static_cast<float>(part.height)},
        packed(color));
  }
}

void Canvas::note(std::string_view text, const TextStyle& style, const Drawn& drawn) {
  if (!is_noting_ || text.empty()) return;
  const float height = fonts_->face(style.type).size() / scale_;
  SeenText seen;
  seen.rect = {drawn.x, drawn.baseline - height * 0.8F, drawn.width, height};
  seen.visible = intersection(seen.rect, clips_.back());
  if (seen.visible.is_empty()) return;
  seen.text = text;
  seen.room = rooms_.back();
  seen.layer = layer_;
  seen.is_shortened = drawn.is_shortened;
  seen.may_be_shortened = drawn.may_be_shortened;
  seen.presence = presence_;
  seen.gives_way = gives_way_;
  if (drawn.is_shortened) seen.whole = drawn.whole;
  seen.hint = drawn.hint;
  content_->texts.push_back(std::move(seen));
}

float Canvas::text_on_baseline(Point at, const TextStyle& style, std::string_view text) {
  const FontFace& face = fonts_->face(style.type);
  const float width = text_width(face, text);
  float pen = at.x * scale_;
  if (style.align == Align::Centre) pen -= width / 2.0F;
  if (style.align == Align::Right) pen -= width;
  pen = std::round(pen);
  draw_glyphs(face, pen, std::round(at.y * scale_), style.color, text);
  note(text, style, {pen / scale_, at.y, width / scale_});
  return width / scale_;
}

float Canvas::text(Point at, const TextStyle& style, std::string_view text) {
  const float half_capital =
      std::floor(fonts_->face(style.type).cap_height() / 2.0F + 0.5F) / scale_;
  return text_on_baseline({at.x, at.y + half_capital}, style, text);
}

float Canvas::text_in(const Rect& box, const TextStyle& style, std::string_view text,
                      bool may_be_shortened, std::string_view hint) {
  const FontFace& face = fonts_->face(style.type);
  // Rounding the box to device pixels may take one away.
  const std::string shown = shortened(face, text, box.w * scale_ + 1.0F);
  const bool is_shortened = shown.size() != text.size() || shown != text;
  const float width = text_width(face, shown) / scale_;
  const float x = style.align == Align::Left     ? box.x
                  : style.align == Align::Centre ? box.mid_x() - width / 2.0F
                                                 : box.right() - width;
  const float half_capital = std::floor(face.cap_height() / 2.0F + 0.5F);
  const float baseline = std::round(box.mid_y() * scale_ + half_capital);
  draw_glyphs(face, std::round(x * scale_), baseline, style.color, shown);
  note(shown, style, {x, baseline / scale_, width, is_shortened, may_be_shortened, text, hint});
  return width;
}

float Canvas::paragraph(const Rect& box, const TextStyle& style, std::string_view text) {
  const float height = line_height(style.type);
  float y = box.y;
  push_room(intersection(rooms_.back(), {box.x, rooms_.back().y, box.w + 1.0F,
                                         box.bottom() - rooms_.back().y + 1.0F}));
  for (const TextLine& each : broken_lines(fonts_->face(style.type), text, box.w * scale_ + 0.5F)) {
    const float x = style.align == Align::Left     ? box.x
                    : style.align == Align::Centre ? box.mid_x()
                                                   : box.right();
    this->text({x, y + height / 2.0F}, style, text.substr(each.begin, each.end - each.begin));
    y += height;
  }
  pop_room();
  return y - box.y;
}

float Canvas::paragraph_height(Type type, std::string_view text, float width) const {
  const auto lines = broken_lines(fonts_->face(type), text, width * scale_ + 0.5F).size();
  return static_cast<float>(lines) * line_height(type);
}

void Canvas::icon(Point centre, Icon icon, IconSize size, Color color) {
  const FontFace& face = fonts_->icon_face(size);
  if (icon == Icon::None || !face.has(static_cast<char32_t>(icon))) return;
  const Glyph& glyph = face.glyph(static_cast<char32_t>(icon));
  const float width = glyph.right - glyph.left, height = glyph.bottom - glyph.top;
  const float x = std::round(centre.x * scale_ - width / 2.0F),
              y = std::round(centre.y * scale_ - height / 2.0F);
  list_->PrimReserve(6, 4);
  list_->PrimRectUV({x, y}, {x + width, y + height}, {glyph.u0, glyph.v0}, {glyph.u1, glyph.v1},
                    packed(color));
}

void Canvas::push_clip(const Rect& rect) {
  clips_.push_back(intersection(clips_.back(), rect));
  const Rect& clip = clips_.back();
  list_->PushClipRect({device(clip.x), device(clip.y)},
                      {device(clip.right()), device(clip.bottom())}, false);
}

void Canvas::pop_clip() {
  clips_.pop_back();
  list_->PopClipRect();
}

Layer Canvas::enter_layer(Layer layer) {
  const Layer before = layer_;
  layer_ = layer;
  clips_.push_back(clips_.front());
  rooms_.push_back(clips_.front());
  list_->ChannelsSetCurrent(static_cast<int>(layer));
  list_->PushClipRectFullScreen();
  return before;
}

void Canvas::leave_layer(Layer before) {
  list_->PopClipRect();
  layer_ = before;
  list_->ChannelsSetCurrent(static_cast<int>(before));
  clips_.pop_back();
  rooms_.pop_back();
}

void Canvas::finish() { list_->ChannelsMerge(); }

}  // namespace hallux::ui
