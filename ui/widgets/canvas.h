/// Draws on a Dear ImGui draw list in logical pixels: crisp edges, own text, and a note of every
/// text drawn.
///
/// Edges of rectangles and glyphs fall on whole device pixels at every content scale; a hairline is
/// never blurred.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "ui/widgets/input/widget.h"
#include "ui/widgets/look/color.h"
#include "ui/widgets/look/fonts.h"
#include "ui/widgets/look/geometry.h"

struct ImDrawList;

namespace hallux::ui {

enum class Corners : std::uint8_t { All, Top, Bottom, None };

struct TextStyle {
  Type type = Type::Body;
  Color color = {};
  Align align = Align::Left;
};

/// A picture that the renderer owns, by its GL texture name; its rows run upwards as GL draws them.
struct Picture {
  std::uint64_t texture = 0;
  bool is_upside_down = true;
};

class Canvas {
 public:
  /// needs  list, fonts and content outlive the canvas
  Canvas(ImDrawList& list, const FontAtlas& fonts, FrameContent& content, const Rect& display);
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;

  // -- filled and stroked forms
  void fill(const Rect& rect, Color color, float radius = 0.0F, Corners corners = Corners::All);
  /// A line along the inner side of the rectangle's edge.
  void outline(const Rect& rect, Color color, float radius = 0.0F, float thickness = 1.0F);
  void hairline_across(float x, float y, float width, Color color);
  void hairline_down(float x, float y, float height, Color color);
  void disc(Point centre, float radius, Color color);
  void ring(Point centre, float radius, Color color, float thickness = 1.5F);
  /// From one angle to another, 0 = three o'clock, clockwise on the screen.
  void arc(Point centre, float radius, float from_rad, float to_rad, Color color, float thickness,
           bool round_ends);
  void line(Point from, Point to, Color color, float thickness);
  /// Points that follow on the same pixel are left out: they would smear.
  void polyline(std::span<const Point> points, Color color, float thickness);
  /// needs  the outline is convex
  void polygon(std::span<const Point> points, Color color);
  void dashes(Point from, Point to, Color color, float on, float off, float thickness);
  void gradient_across(const Rect& rect, Color left, Color right);
  void picture(const Picture& picture, const Rect& rect, float radius = 0.0F,
               Corners corners = Corners::All);

  // -- text; each returns the width drawn
  float width_of(Type type, std::string_view text) const noexcept;
  float text_on_baseline(Point at, const TextStyle& style, std::string_view text);
  /// Capitals centred on at.y.
  float text(Point at, const TextStyle& style, std::string_view text);
  /// Centred in height inside `box`, aligned across; what does not fit ends in an ellipsis and
  /// counts as cut off unless `may_be_shortened` (a person's own words). What was cut is shown
  /// whole while the pointer rests on it, or `hint` where there is one.
  float text_in(const Rect& box, const TextStyle& style, std::string_view text,
                bool may_be_shortened = false, std::string_view hint = {});
  /// Lines broken to the width of `box`, from its top; returns their height. What exceeds the box
  /// counts as cut off.
  float paragraph(const Rect& box, const TextStyle& style, std::string_view text);
  float paragraph_height(Type type, std::string_view text, float width) const;
  /// Centred on the ink of the glyph.
  void icon(Point centre, Icon icon, IconSize size, Color color);

  // -- where drawing goes
  /// What is drawn from now on shows through: 1 is as it is, towards 0 it goes. Texts stay noted.
  void set_presence(float share) noexcept { presence_ = share; }
  /// From here on texts give way to messages, see SeenText; until it is set back.
  void set_giving_way(bool gives_way) noexcept { gives_way_ = gives_way; }

  void push_clip(const Rect& rect);
  void pop_clip();
  /// Texts drawn until pop_room must stay inside `rect`; a text that does not is found by the
  /// tests.
  void push_room(const Rect& rect) { rooms_.push_back(rect); }
  void pop_room() { rooms_.pop_back(); }
  /// Draws on `layer`, over the whole display, until leave_layer is given what this returned.
  Layer enter_layer(Layer layer);
  void leave_layer(Layer before);
  Layer layer() const noexcept { return layer_; }
  const Rect& clip() const noexcept { return clips_.back(); }
  const Rect& display() const noexcept { return clips_.front(); }
  /// Brings the layers together; nothing may be drawn after it.
  void finish();
  /// A text that a control drew by other means than the canvas (an edited field) is noted by it.
  void note_text(const SeenText& seen) { content_->texts.push_back(seen); }
  /// Texts drawn while this is off are no reading matter: the hidden letters of a password.
  void set_noting(bool is_on) noexcept { is_noting_ = is_on; }

  const FontAtlas& fonts() const noexcept { return *fonts_; }
  float scale() const noexcept { return scale_; }

 private:
  float device(float logical) const noexcept;
  unsigned packed(Color color) const noexcept;
  void draw_glyphs(const FontFace& face, float pen, float baseline, Color color,
                   std::string_view text);
  void draw_code_box(const FontFace& face, Point pen, Color color, char32_t letter);
  /// A text as it was drawn, before it is noted.
  struct Drawn {
    float x = 0.0F, baseline = 0.0F, width = 0.0F;
    bool is_shortened = false, may_be_shortened = false;
    std::string_view whole = {}, hint = {};
  };
  void note(std::string_view text, const TextStyle& style, const Drawn& drawn);

  ImDrawList* list_;
  const FontAtlas* fonts_;
  FrameContent* content_;
  float scale_;
  Layer layer_ = Layer::Page;
  bool is_noting_ = true;
  float presence_ = 1.0F;
  bool gives_way_ = false;
  std::vector<Rect> clips_, rooms_;
};

/// Clips, and ends clipping with the scope.
class ClipScope {
 public:
  ClipScope(Canvas& canvas, const Rect& rect) : canvas_(canvas) { canvas_.push_clip(rect); }
  ClipScope(const ClipScope&) = delete;
  ClipScope& operator=(const ClipScope&) = delete;
  ~ClipScope() { canvas_.pop_clip(); }

 private:
  Canvas& canvas_;
};

/// Draws on another layer until the scope ends.
class LayerScope {
 public:
  LayerScope(Canvas& canvas, Layer layer) : canvas_(canvas), before_(canvas.enter_layer(layer)) {}
  LayerScope(const LayerScope&) = delete;
  LayerScope& operator=(const LayerScope&) = delete;
  ~LayerScope() { canvas_.leave_layer(before_); }

 private:
  Canvas& canvas_;
  Layer before_;
};

}  // namespace hallux::ui
