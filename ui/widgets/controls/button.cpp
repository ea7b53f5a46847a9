#include "ui/widgets/controls/button.h"

#include <cmath>

#include "ui/widgets/controls/tooltip.h"
#include "ui/widgets/shapes.h"

namespace hallux::ui {
namespace {

constexpr float icon_gap = 24.0F, padding = 16.0F, min_width = 88.0F;

struct ButtonColors {
  Color fill, border, ink;
};

Color opaque(Color color) {
  color.alpha = 255;
  return color;
}

ButtonColors resting(const Theme& theme, ButtonLook look) {
  switch (look) {
    case ButtonLook::Primary:
      return {theme.accent, rgb(0, 0), theme.on_accent};
    case ButtonLook::Ghost:
      return {faded(theme.raise, 0.0F), rgb(0, 0), theme.text_secondary};
    case ButtonLook::Danger:
      return {theme.danger, theme.danger_border, theme.bad_text};
    case ButtonLook::Secondary:
      break;
  }
  return {theme.is_dark() ? theme.raise : theme.card, theme.control_border, theme.text};
}

ButtonColors colors_of(const Theme& theme, const ButtonSpec& spec, const ControlState& state) {
  ButtonColors colors = resting(theme, spec.look);
  const bool is_primary = spec.look == ButtonLook::Primary,
             is_ghost = spec.look == ButtonLook::Ghost;
  if (!spec.why_off.empty())
    return {is_ghost ? rgb(0, 0) : theme.raise, is_ghost ? rgb(0, 0) : theme.line,
            faded(theme.text_caption, 0.62F)};
  const Color towards = theme.is_dark() ? rgb(0xFFFFFF) : rgb(0x14202A);
  if (state.is_held) {
    if (is_ghost) return {opaque(mixed(theme.raise, towards, 0.06F)), colors.border, theme.text};
    colors.fill =
        mixed(colors.fill, theme.is_dark() ? rgb(0) : towards, is_primary ? 0.22F : 0.12F);
  } else if (state.hover > 0.0F) {
    const Color hovered =
        is_ghost ? theme.raise : mixed(colors.fill, towards, is_primary ? 0.12F : 0.06F);
    colors.fill = mixed(colors.fill, hovered, state.hover);
    if (is_ghost) colors.ink = mixed(colors.ink, theme.text, state.hover);
  }
  return colors;
}

std::string_view why_off(const Ui& ui, const ButtonSpec& spec) {
  return spec.is_busy ? ui.text("button.busy") : spec.why_off;
}

}  // namespace

float button_width(const Ui& ui, const ButtonSpec& spec) {
  const float label = ui.width_of(Type::BodyMedium, spec.label);
  const bool has_icon = spec.icon != Icon::None || spec.is_busy;
  return std::max(min_width, std::ceil(label) + 2.0F * padding + (has_icon ? icon_gap : 0.0F));
}

void draw_button(Ui& ui, const Rect& rect, const ButtonSpec& spec, const ControlState& state) {
  Canvas& canvas = ui.canvas();
  const ButtonColors colors = colors_of(ui.theme(), spec, state);
  canvas.fill(rect, colors.fill, radius::control);
  canvas.outline(rect, colors.border, radius::control);
  if (state.shows_ring) draw_focus_ring(canvas, ui.theme(), rect, radius::control);
  const float gap = spec.icon != Icon::None || spec.is_busy ? icon_gap : 0.0F;
  const float room = rect.w - gap - 8.0F;
  const float width = std::min(canvas.width_of(Type::BodyMedium, spec.label), room);
  const float x = rect.mid_x() - (width + gap) / 2.0F;
  if (spec.is_busy)
    draw_spinner(canvas, {x + 7.0F, rect.mid_y()}, 6.0F, colors.ink);
  else
    canvas.icon({x + 7.0F, rect.mid_y()}, spec.icon, IconSize::Control, colors.ink);
  canvas.text_in({x + gap, rect.y, room, rect.h}, {Type::BodyMedium, colors.ink}, spec.label);
}

bool button(Ui& ui, std::string_view id, const Rect& rect, const ButtonSpec& spec) {
  const std::string_view why = why_off(ui, spec);
  const Response response = ui.control({.id = std::string(id),
                                        .label = std::string(spec.label),
                                        .rect = rect,
                                        .is_enabled = why.empty(),
                                        .why_off = std::string(why),
                                        .is_primary = spec.look == ButtonLook::Primary});
  draw_button(ui, rect, spec, {response.hover, response.is_held, response.shows_ring});
  if (!why.empty()) tell_why_off(ui, id, rect, why);
  return response.is_pressed();
}

bool button_in_line(Ui& ui, std::string_view id, Rect line, const ButtonSpec& spec) {
  line.w = std::min(line.w, button_width(ui, spec));
  return button(ui, id, line, spec);
}

bool icon_button(Ui& ui, std::string_view id, const Rect& rect, const IconButtonSpec& spec) {
  const Response response = ui.control({.id = std::string(id),
                                        .label = std::string(spec.label),
                                        .rect = rect,
                                        .is_enabled = spec.why_off.empty(),
                                        .why_off = std::string(spec.why_off),
                                        .comes_late = spec.comes_late});
  Canvas& canvas = ui.canvas();
  const Theme& theme = ui.theme();
  if (spec.is_on)
    canvas.fill(rect, theme.accent_soft, radius::control);
  else
    canvas.fill(rect, faded(theme.raise, response.is_held ? 1.0F : response.hover),
                radius::control);
  if (response.shows_ring) draw_focus_ring(canvas, theme, rect, radius::control);
  const Color ink = !spec.why_off.empty() ? faded(theme.text_caption, 0.5F)
                    : spec.is_on          ? theme.accent
                                          : mixed(theme.text_secondary, theme.text, response.hover);
  canvas.icon(rect.centre(), spec.icon, IconSize::Control, ink);
  if (spec.why_off.empty()) {
    tooltip_when_resting(ui, id, rect, spec.label);
  } else {
    tell_why_off(ui, id, rect, std::string(spec.label) + ": " + std::string(spec.why_off));
  }
  return response.is_pressed();
}

bool link(Ui& ui, std::string_view id, Point at, std::string_view label, Align align, Type type) {
  const float width = ui.canvas().width_of(type, label);
  const float x = align == Align::Left    ? at.x
                  : align == Align::Right ? at.x - width
                                          : at.x - width / 2.0F;
  Widget widget{.id = std::string(id),
                .label = std::string(label),
                .rect = {x - 4.0F, at.y - 12.0F, width + 8.0F, 24.0F},
                .role = Role::Link};
  const Rect rect = widget.rect;
  const Response response = ui.control(std::move(widget));
  ui.canvas().text({x, at.y}, {type, ui.theme().accent}, label);
  if (response.hover > 0.0F)
    ui.canvas().hairline_across(x, at.y + 8.0F, width, faded(ui.theme().accent, response.hover));
  if (response.shows_ring)
    draw_focus_ring(ui.canvas(), ui.theme(), inset(rect, 1.0F), radius::step);
  return response.is_pressed();
}

}  // namespace hallux::ui
