// Controls with which one chooses. What is drawn is what was chosen when the frame began; a press
// changes it for the next frame, which is asked for at once. Options of one choice are a group: Tab
// visits it once, arrows move inside.
#include "ui/widgets/controls/choice.h"

#include <string>

#include "ui/widgets/controls/tooltip.h"
#include "ui/widgets/shapes.h"

namespace hallux::ui {
namespace {

constexpr float thumb_inset = 3.0F, segment_padding = 16.0F;

Widget option_widget(std::string_view group, std::size_t number, std::string_view label,
                     const Rect& rect, bool is_chosen) {
  Widget widget{.id = std::string(group) + "." + std::to_string(number),
                .label = std::string(label),
                .rect = rect,
                .role = Role::Option,
                .is_chosen = is_chosen,
                .group = std::string(group)};
  return widget;
}

// Widths of the segments: each label with an equal share of what is left.
std::vector<Rect> segments_of(const Ui& ui, const Rect& rect,
                              std::span<const std::string_view> labels) {
  float words = 0.0F;
  for (const std::string_view label : labels) words += ui.width_of(Type::SmallMedium, label);
  const float share =
      (rect.w - words) / static_cast<float>(std::max<std::size_t>(labels.size(), 1));
  std::vector<Rect> segments;
  float x = rect.x;
  for (const std::string_view label : labels) {
    const float width = ui.width_of(Type::SmallMedium, label) + share;
    segments.push_back({x, rect.y, width, rect.h});
    x += width;
  }
  return segments;
}

bool switch_control(Ui& ui, std::string_view id, const Rect& rect, std::string_view label,
                    bool& is_on, std::string_view why_off, Response& response) {
  response = ui.control({.id = std::string(id),
                         .label = std::string(label),
                         .rect = rect,
                         .role = Role::Checkbox,
                         .is_enabled = why_off.empty(),
                         .why_off = std::string(why_off)});
  if (!why_off.empty()) tell_why_off(ui, id, rect, why_off);
  if (response.is_pressed()) is_on = !is_on;
  return response.is_pressed();
}

}  // namespace

float segmented_width(const Ui& ui, std::span<const std::string_view> labels) {
  float width = 0.0F;
  for (const std::string_view label : labels)
    width += ui.width_of(Type::SmallMedium, label) + 2.0F * segment_padding;
  return width;
}

bool segmented(Ui& ui, std::string_view id, const Rect& rect,
               std::span<const std::string_view> labels, int& chosen) {
  Canvas& canvas = ui.canvas();
  const Theme& theme = ui.theme();
  canvas.fill(rect, theme.is_dark() ? theme.raise : theme.chip, radius::control);
  const std::vector<Rect> segments = segments_of(ui, rect, labels);
  const int before = chosen;
  for (std::size_t number = 0; number < labels.size(); ++number) {
    const int own = static_cast<int>(number);
    const Rect thumb = inset(segments[number], thumb_inset);
    const Response response =
        ui.control(option_widget(id, number, labels[number], segments[number], before == own));
    if (response.is_pressed()) chosen = own;
    const bool is_chosen = before == own;
    if (is_chosen) {
      draw_shadow(canvas, theme, thumb, radius::row, Elevation::Card);
      canvas.fill(thumb, theme.thumb, radius::row);
    }
    if (number > 0 && !is_chosen && before + 1 != own && !response.shows_ring)
      canvas.hairline_down(segments[number].x, rect.y + 11.0F, rect.h - 22.0F,
                           faded(theme.border, 0.45F));
    if (response.shows_ring) draw_focus_ring(canvas, theme, thumb, radius::row);
    const Color ink =
        is_chosen ? theme.text : mixed(theme.text_secondary, theme.text, response.hover);
    canvas.text_in(inset(segments[number], 4.0F, 0.0F),
                   {is_chosen ? Type::SmallMedium : Type::Small, ink, Align::Centre},
                   labels[number]);
  }
  if (chosen != before) ui.want_frame_in_s(0.0);
  return chosen != before;
}

bool tabs(Ui& ui, std::string_view id, const Rect& rect, std::span<const std::string_view> labels,
          int& chosen) {
  Canvas& canvas = ui.canvas();
  const Theme& theme = ui.theme();
  canvas.hairline_across(rect.x, rect.y + tabs_height - 1.0F, rect.w, theme.line);
  const int before = chosen;
  float x = rect.x;
  for (std::size_t number = 0; number < labels.size(); ++number) {
    const float width = ui.width_of(Type::BodyMedium, labels[number]);
    const Rect tab{x, rect.y, width, tabs_height};
    const bool is_chosen = before == static_cast<int>(number);
    const Response response =
        ui.control(option_widget(id, number, labels[number], inset(tab, -8.0F, 0.0F), is_chosen));
    if (response.is_pressed()) chosen = static_cast<int>(number);
    const Color ink =
        is_chosen ? theme.text : mixed(theme.text_caption, theme.text, response.hover);
    canvas.text({x, rect.y + 18.0F}, {Type::BodyMedium, ink}, labels[number]);
    if (is_chosen) canvas.fill({x, rect.y + tabs_height - 3.0F, width, 3.0F}, theme.accent, 1.5F);
    if (response.shows_ring) draw_focus_ring(canvas, theme, inset(tab, -3.0F, 7.0F), radius::step);
    x += width + tab_gap;
  }
  if (chosen != before) ui.want_frame_in_s(0.0);
  return chosen != before;
}

void draw_checkbox(Ui& ui, const Rect& box, bool is_on, bool is_enabled,
                   const ControlState& state) {
  Canvas& canvas = ui.canvas();
  const Theme& theme = ui.theme();
  if (is_on) {
    canvas.fill(box, is_enabled ? theme.accent : theme.text_caption, 5.0F);
    draw_tick(canvas, box.centre(), 9.0F, theme.on_accent, 2.0F);
  } else {
    canvas.fill(box, is_enabled ? theme.field : theme.raise, 5.0F);
    canvas.outline(box,
                   is_enabled ? mixed(theme.border, theme.text, state.hover * 0.5F) : theme.line,
                   5.0F, 1.5F);
  }
  if (state.shows_ring) draw_focus_ring(canvas, theme, box, 5.0F);
}

void draw_toggle(Ui& ui, const Rect& track, bool is_on, bool is_enabled,
                 const ControlState& state) {
  Canvas& canvas = ui.canvas();
  const Theme& theme = ui.theme();
  const Color fill = !is_enabled ? theme.chip : is_on ? theme.accent : theme.toggle_off;
  canvas.fill(track, mixed(fill, theme.text, state.hover * 0.1F), track.h / 2.0F);
  const float x = is_on ? track.right() - 10.0F : track.x + 10.0F;
  canvas.disc({x, track.mid_y()}, 7.0F, is_on ? theme.on_accent : theme.card);
  if (state.shows_ring) draw_focus_ring(canvas, theme, track, track.h / 2.0F);
}

bool checkbox(Ui& ui, std::string_view id, const Rect& rect, std::string_view label, bool& is_on,
              bool is_label_shown, std::string_view why_off) {
  Response response;
  const bool is_changed = switch_control(ui, id, rect, label, is_on, why_off, response);
  draw_checkbox(ui, {rect.x, rect.mid_y() - 9.0F, 18.0F, 18.0F}, is_on, why_off.empty(),
                {response.hover, response.is_held, response.shows_ring});
  if (is_label_shown)
    ui.canvas().text_in({rect.x + 28.0F, rect.y, rect.w - 28.0F, rect.h},
                        {Type::Small, why_off.empty() ? ui.theme().text : ui.theme().text_caption},
                        label);
  return is_changed;
}

bool toggle(Ui& ui, std::string_view id, const Rect& rect, std::string_view label, bool& is_on,
            bool is_label_shown, std::string_view why_off) {
  Response response;
  const bool is_changed = switch_control(ui, id, rect, label, is_on, why_off, response);
  draw_toggle(ui, {rect.x, rect.mid_y() - 10.0F, 36.0F, 20.0F}, is_on, why_off.empty(),
              {response.hover, response.is_held, response.shows_ring});
  if (is_label_shown)
    ui.canvas().text_in({rect.x + 46.0F, rect.y, rect.w - 46.0F, rect.h},
                        {Type::Small, why_off.empty() ? ui.theme().text : ui.theme().text_caption},
                        label);
  return is_changed;
}

bool filter_pill(Ui& ui, std::string_view id, Point left_middle, std::string_view label,
                 bool is_chosen, float* width) {
  const Rect rect{left_middle.x, left_middle.y - 12.0F,
                  ui.width_of(Type::CaptionMedium, label) + 20.0F, 24.0F};
  if (width != nullptr) *width = rect.w;
  const Response response = ui.control(
      {.id = std::string(id), .label = std::string(label), .rect = rect, .is_chosen = is_chosen});
  Canvas& canvas = ui.canvas();
  const Theme& theme = ui.theme();
  const Color fill = is_chosen ? theme.accent_soft : theme.chip;
  canvas.fill(rect, mixed(fill, theme.text, response.hover * 0.06F), 12.0F);
  if (response.shows_ring) draw_focus_ring(canvas, theme, rect, 12.0F);
  canvas.text_in(
      rect, {Type::CaptionMedium, is_chosen ? theme.accent : theme.text_secondary, Align::Centre},
      label);
  return response.is_pressed();
}

}  // namespace hallux::ui
