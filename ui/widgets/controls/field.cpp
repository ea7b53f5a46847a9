// A field draws its letters itself, since dots, selection and caret need the same places as the
// text. Events of the frame are applied in their order, first the pointer and then keys, on the
// text as it was shown. What a secret shows are dots, mapped letter by letter; its text is noted
// nowhere, and copies are wiped.
#include "ui/widgets/controls/field.h"

#include <cmath>

#include "ui/widgets/controls/tooltip.h"
#include "ui/widgets/shapes.h"
#include "ui/widgets/texts/text_layout.h"
#include "ui/widgets/texts/wipe.h"

namespace hallux::ui {
namespace {

constexpr float padding = 14.0F, icon_room = 24.0F, eye_room = 40.0F, caret_width = 2.0F;
constexpr std::string_view dot = "\xE2\x80\xA2";

// The letters as they are shown: themselves, or a dot for each.
class Shown {
 public:
  Shown(std::string_view text, bool is_hidden) : text_(text), is_hidden_(is_hidden) {
    if (!is_hidden) return;
    for (std::size_t place = 0; place < text.size(); place = following_place(text, place))
      dots_ += dot;
  }
  std::string_view view() const { return is_hidden_ ? std::string_view(dots_) : text_; }
  std::size_t to_shown(std::size_t place) const {
    if (!is_hidden_) return place;
    std::size_t letters = 0;
    for (std::size_t at = 0; at < place; at = following_place(text_, at)) ++letters;
    return letters * dot.size();
  }
  std::size_t from_shown(std::size_t place) const {
    if (!is_hidden_) return place;
    std::size_t at = 0;
    for (std::size_t letters = place / dot.size(); letters > 0; --letters)
      at = following_place(text_, at);
    return at;
  }

 private:
  std::string_view text_;
  bool is_hidden_;
  std::string dots_;
};

// The text broken into the lines of the field, with what is needed to go from a point to a place
// and back.
struct Layout {
  std::vector<TextLine> lines;
  std::string_view text;
  const FontFace* face = nullptr;
  float scale = 1.0F, line_step = 24.0F;

  std::size_t line_of(std::size_t place) const {
    std::size_t line = lines.size() - 1;
    while (line > 0 && place < lines[line].begin) --line;
    return line;
  }
  float x_of(std::size_t place) const {
    const TextLine& line = lines[line_of(place)];
    const std::size_t end = std::min(place, std::max(line.end, line.begin));
    return text_width(*face, text.substr(line.begin, end - line.begin)) / scale;
  }
  std::size_t place_of(float x, float y) const {
    const float number =
        std::clamp(std::floor(y / line_step), 0.0F, static_cast<float>(lines.size() - 1));
    const TextLine& line = lines[static_cast<std::size_t>(number)];
    return line.begin + place_at(*face, text.substr(line.begin, line.end - line.begin), x * scale);
  }
};

Layout lay_out(Ui& ui, std::string_view text, const FieldSpec& spec, float width) {
  Layout layout;
  layout.text = text;
  layout.face = &ui.canvas().fonts().face(Type::Body);
  layout.scale = ui.scale();
  layout.line_step = line_height(Type::Body);
  layout.lines = spec.lines > 1 ? broken_lines(*layout.face, text, width * layout.scale)
                                : std::vector<TextLine>{{0, text.size()}};
  return layout;
}

Rect room_of(const Rect& rect, const FieldSpec& spec) {
  Rect room = inset(rect, padding, spec.lines > 1 ? 9.0F : 0.0F);
  if (spec.icon != Icon::None || !spec.why_off.empty()) room.x += icon_room, room.w -= icon_room;
  if (spec.is_secret && spec.why_off.empty()) room.w -= eye_room - padding;
  return room;
}

// Up and Down go to the same x in the next line.
bool press_line_key(TextEdit& edit, const Layout& layout, Chord chord) {
  if (layout.lines.size() < 2 || (chord.key != Key::Up && chord.key != Key::Down)) return false;
  const std::size_t line = layout.line_of(edit.cursor.caret);
  const bool is_up = chord.key == Key::Up;
  if (is_up ? line == 0 : line + 1 == layout.lines.size()) return true;
  const float target = static_cast<float>(is_up ? line - 1 : line + 1) + 0.5F;
  move_caret(edit, layout.place_of(layout.x_of(edit.cursor.caret), target * layout.line_step),
             chord.modifiers.shift);
  return true;
}

bool apply_events(Ui& ui, const std::string& id, TextEdit& edit, std::string& text,
                  const FieldSpec& spec, float width) {
  const EditRules rules{spec.max_bytes, spec.lines > 1, spec.is_secret};
  std::string before = text;
  for (const FieldEvent& event : ui.field_events(id)) {
    if (event.character != 0)
      type_character(edit, text, event.character, rules);
    else if (!press_line_key(edit, lay_out(ui, text, spec, width), event.chord))
      press_edit_key(edit, text, event.chord, rules, ui.clipboard());
  }
  const bool is_changed = text != before;
  if (spec.is_secret) wipe(before);
  return is_changed;
}

void apply_pointer(Ui& ui, const Response& response, TextEdit& edit, std::string_view text,
                   const Shown& shown, const Layout& layout, const Rect& room) {
  if (!response.is_held && !response.is_pressed()) return;
  const float top = layout.lines.size() > 1 || room.h > 2.0F * layout.line_step
                        ? room.y
                        : room.mid_y() - layout.line_step / 2.0F;
  const std::size_t place = shown.from_shown(layout.place_of(
      ui.pointer().x - room.x + edit.scrolled_x, ui.pointer().y - top + edit.scrolled_y));
  if (response.is_double)
    select_word(edit, text, place);
  else
    move_caret(edit, place, !response.is_pressed() || ui.modifiers().shift);
}

// Scrolls so that the caret is inside the room.
void follow_caret(TextEdit& edit, const Layout& layout, std::size_t caret, const Rect& room,
                  bool is_multiline) {
  const float x = layout.x_of(caret);
  const float end = layout.x_of(layout.text.size());
  if (is_multiline) {
    const float y = static_cast<float>(layout.line_of(caret)) * layout.line_step;
    const float longest =
        std::max(0.0F, static_cast<float>(layout.lines.size()) * layout.line_step - room.h);
    edit.scrolled_y =
        std::clamp(std::clamp(edit.scrolled_y, y + layout.line_step - room.h, y), 0.0F, longest);
    edit.scrolled_x = 0.0F;
    return;
  }
  edit.scrolled_x =
      std::clamp(edit.scrolled_x, x - room.w + 2.0F, std::max(x - room.w + 2.0F, x - 2.0F));
  edit.scrolled_x = std::clamp(edit.scrolled_x, 0.0F, std::max(0.0F, end - room.w + 2.0F));
}

Color border_of(const Theme& theme, const FieldSpec& spec, const ControlState& state,
                bool has_focus) {
  if (!spec.why_off.empty()) return theme.line;
  if (!spec.error.empty()) return theme.bad;
  if (has_focus) return theme.accent;
  return mixed(theme.border, theme.text_caption, state.hover);
}

void draw_message(Ui& ui, const Rect& rect, const FieldSpec& spec) {
  Canvas& canvas = ui.canvas();
  const float y = rect.bottom() + 16.0F;
  if (!spec.error.empty()) {
    draw_meaning(canvas, ui.theme(), Meaning::Bad, {rect.x + 6.0F, y}, 5.5F);
    canvas.text({rect.x + 20.0F, y}, {Type::Small, ui.theme().bad_text}, spec.error);
  } else if (!spec.hint.empty()) {
    canvas.text({rect.x, y}, {Type::Small, ui.theme().text_caption}, spec.hint);
  }
}

void draw_box(Ui& ui, const Rect& rect, const FieldSpec& spec, const ControlState& state,
              bool has_focus) {
  Canvas& canvas = ui.canvas();
  const Theme& theme = ui.theme();
  if (spec.is_label_shown)
    canvas.text_on_baseline({rect.x, rect.y - 9.0F}, {Type::SmallMedium, theme.text}, spec.label);
  canvas.fill(rect, spec.why_off.empty() ? theme.field : theme.raise, radius::control);
  const bool is_strong = spec.why_off.empty() && (has_focus || !spec.error.empty());
  canvas.outline(rect, border_of(theme, spec, state, has_focus), radius::control,
                 is_strong ? 2.0F : 1.0F);
  // One that is on shows by its edge that it is written into.
  if (state.shows_ring && !spec.why_off.empty())
    draw_focus_ring(canvas, theme, rect, radius::control);
  const Icon icon = spec.why_off.empty() ? spec.icon : Icon::Lock;
  canvas.icon({rect.x + padding + 6.0F, rect.mid_y()}, icon, IconSize::Control, theme.text_caption);
  draw_message(ui, rect, spec);
}

// Selection, letters and caret inside the room.
void draw_letters(Ui& ui, const Rect& room, const Layout& layout, const TextEdit& edit,
                  const TextCursor& cursor, const FieldSpec& spec, bool has_focus) {
  Canvas& canvas = ui.canvas();
  const Theme& theme = ui.theme();
  const ClipScope clip(canvas, inset(room, -2.0F, 0.0F));
  float y = spec.lines > 1 ? room.y - edit.scrolled_y : room.mid_y() - layout.line_step / 2.0F;
  const float left = room.x - edit.scrolled_x;
  for (std::size_t line = 0; line < layout.lines.size(); ++line, y += layout.line_step) {
    const TextLine& each = layout.lines[line];
    const std::string_view letters = layout.text.substr(each.begin, each.end - each.begin);
    const auto x_in_line = [&](std::size_t place) {
      const std::size_t inside = std::clamp(place, each.begin, each.end) - each.begin;
      return left + text_width(*layout.face, letters.substr(0, inside)) / layout.scale;
    };
    if (has_focus && cursor.begin() < each.end && cursor.end() > each.begin &&
        cursor.has_selection())
      canvas.fill({x_in_line(cursor.begin()), y + 2.0F,
                   x_in_line(cursor.end()) - x_in_line(cursor.begin()), 20.0F},
                  theme.accent_soft, 2.0F);
    canvas.text({left, y + layout.line_step / 2.0F},
                {Type::Body, spec.why_off.empty() ? theme.text : theme.text_caption}, letters);
    if (has_focus && layout.line_of(cursor.caret) == line)
      canvas.fill({x_in_line(cursor.caret) + 0.5F, y + 3.0F, caret_width, 18.0F}, theme.accent);
  }
}

void draw_content(Ui& ui, const Rect& room, std::string_view shown, const Layout& layout,
                  const TextEdit& edit, const TextCursor& cursor, const FieldSpec& spec,
                  bool has_focus) {
  Canvas& canvas = ui.canvas();
  if (shown.empty() && !spec.placeholder.empty()) {
    const Rect line = spec.lines > 1 ? Rect{room.x, room.y, room.w, layout.line_step} : room;
    canvas.text_in(line, {Type::Body, ui.theme().text_caption}, spec.placeholder);
  }
  canvas.set_noting(false);
  draw_letters(ui, room, layout, edit, cursor, spec, has_focus);
  canvas.set_noting(true);
  const Rect seen = intersection(room, canvas.clip());
  if (!spec.is_secret && !shown.empty() && !seen.is_empty())
    canvas.note_text({.text = std::string(shown),
                      .rect = seen,
                      .room = room,
                      .visible = seen,
                      .layer = canvas.layer(),
                      .may_be_shortened = true});
}

// Tab goes on from the letters to what comes next, not to the eye: whoever types a phrase there by
// mistake would show it.
bool draw_eye(Ui& ui, const std::string& id, const Rect& rect, bool is_open) {
  const std::string eye = id + ".eye";
  IconButtonSpec spec{.label = ui.text(is_open ? "field.hide" : "field.show"),
                      .icon = is_open ? Icon::EyeOff : Icon::Eye,
                      .comes_late = true};
  return icon_button(ui, eye, {rect.right() - eye_room, rect.mid_y() - 18.0F, 36.0F, 36.0F}, spec);
}

}  // namespace

bool field(Ui& ui, std::string_view id, const Rect& rect, std::string& text,
           const FieldSpec& spec) {
  const std::string name(id);
  const Response response = ui.control({.id = name,
                                        .label = std::string(spec.label),
                                        .rect = rect,
                                        .role = Role::Field,
                                        .is_enabled = spec.why_off.empty(),
                                        .why_off = std::string(spec.why_off),
                                        .takes_new_line = spec.lines > 1,
                                        .takes_tab = spec.takes_tab});
  draw_box(ui, rect, spec, {response.hover, false, response.shows_ring}, response.has_focus);
  TextEdit& edit = ui.text_edit(name);
  keep_cursor_inside(edit, text);
  const Rect room = room_of(rect, spec);
  if (response.is_pressed() || response.is_held) {
    const Shown before(text, spec.is_secret && !edit.is_revealed);
    apply_pointer(ui, response, edit, text, before, lay_out(ui, before.view(), spec, room.w), room);
  }
  const bool is_changed = spec.why_off.empty() && apply_events(ui, name, edit, text, spec, room.w);
  const Shown shown(text, spec.is_secret && !edit.is_revealed);
  const Layout layout = lay_out(ui, shown.view(), spec, room.w);
  const TextCursor cursor{shown.to_shown(edit.cursor.caret), shown.to_shown(edit.cursor.anchor)};
  follow_caret(edit, layout, cursor.caret, room, spec.lines > 1);
  draw_content(ui, room, shown.view(), layout, edit, cursor, spec, response.has_focus);
  if (!spec.why_off.empty()) tell_why_off(ui, id, rect, spec.why_off);
  if (spec.is_secret && spec.why_off.empty() && draw_eye(ui, name, rect, edit.is_revealed)) {
    edit.is_revealed = !edit.is_revealed;
    ui.want_frame_in_s(0.0);
  }
  return is_changed;
}

bool labelled_field(Ui& ui, std::string_view id, Rect& rest, std::string& text,
                    const FieldSpec& spec, float below) {
  take_top(rest, field_label_height);
  return field(ui, id, take_top(rest, field_height, below), text, spec);
}

bool search_field(Ui& ui, std::string_view id, const Rect& rect, std::string& text,
                  std::string_view label) {
  return field(
      ui, id, rect, text,
      {.label = label, .placeholder = label, .icon = Icon::Search, .is_label_shown = false});
}

void draw_field(Ui& ui, const Rect& rect, std::string_view text, const FieldSpec& spec,
                const ControlState& state, bool has_focus) {
  draw_box(ui, rect, spec, state, has_focus);
  const Rect room = room_of(rect, spec);
  const Layout layout = lay_out(ui, text, spec, room.w);
  draw_content(ui, room, text, layout, {}, {text.size(), text.size()}, spec, has_focus);
}

}  // namespace hallux::ui
