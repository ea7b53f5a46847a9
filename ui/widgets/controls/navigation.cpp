#include "ui/widgets/controls/navigation.h"

#include <string>

#include "ui/widgets/controls/marks.h"
#include "ui/widgets/controls/tooltip.h"
#include "ui/widgets/shapes.h"

namespace hallux::ui {
namespace {

constexpr float row_height = 40.0F, row_step = 44.0F, side_inset = 12.0F, first_row = 84.0F;
constexpr float narrow = 1180.0F, help_above_foot = 132.0F, gap_edge = 8.0F;

// Below this height the rows move together, so that the person at the foot stays visible.
float step_of(const Rect& display, std::size_t items) {
  const float room = display.h - first_row - 140.0F;
  return std::clamp(room / static_cast<float>(std::max<std::size_t>(items, 1)), 28.0F, row_step);
}

void draw_badge(Ui& ui, const Rect& row, int count, bool is_chosen, bool is_rail) {
  const Theme& theme = ui.theme();
  if (is_rail) {
    ui.canvas().disc({row.right() - 9.0F, row.y + 10.0F}, 4.0F, theme.accent);
    return;
  }
  const Rect badge{row.right() - 34.0F, row.mid_y() - 10.0F, 24.0F, 20.0F};
  ui.canvas().fill(badge, is_chosen ? theme.accent_soft : theme.badge, 10.0F);
  ui.canvas().text_in(
      badge, {Type::CaptionMedium, is_chosen ? theme.accent : theme.text_secondary, Align::Centre},
      count > 99 ? "99+" : std::to_string(count));
}

Response navigation_row(Ui& ui, const Rect& row, std::string_view id, std::string_view label,
                        bool is_chosen = false) {
  return ui.control({.id = std::string(id),
                     .label = std::string(label),
                     .rect = row,
                     .role = Role::Link,
                     .is_chosen = is_chosen});
}

bool draw_item(Ui& ui, const Rect& row, const NavigationItem& item, bool is_chosen, bool is_rail) {
  const Theme& theme = ui.theme();
  const Response response = navigation_row(ui, row, item.id, item.label, is_chosen);
  Canvas& canvas = ui.canvas();
  if (is_chosen) {
    canvas.fill(row, theme.side_chosen, radius::control);
    if (!theme.is_dark()) canvas.outline(row, theme.line, radius::control);
  } else {
    canvas.fill(row, faded(theme.raise, response.hover), radius::control);
  }
  if (response.shows_ring) draw_focus_ring(canvas, theme, row, radius::control);
  const float icon_x = is_rail ? row.mid_x() : row.x + 20.0F;
  canvas.icon({icon_x, row.mid_y()}, item.icon, IconSize::Control,
              is_chosen ? theme.accent : theme.text_caption);
  if (!is_rail) {
    const float room = row.w - 42.0F - (item.badge > 0 ? 40.0F : 8.0F);
    canvas.text_in(
        {row.x + 42.0F, row.y, room, row.h},
        {is_chosen ? Type::BodyMedium : Type::Body, is_chosen ? theme.text : theme.text_secondary},
        item.label);
  } else {
    tooltip_when_resting(ui, item.id, row, item.label);
  }
  if (item.badge > 0) draw_badge(ui, row, item.badge, is_chosen, is_rail);
  return response.is_pressed();
}

bool draw_help(Ui& ui, const Rect& row, bool is_rail) {
  const std::string_view label = ui.text("navigation.help");
  const Response response = navigation_row(ui, row, "nav.help", label);
  Canvas& canvas = ui.canvas();
  canvas.fill(row, faded(ui.theme().raise, response.hover), radius::control);
  if (response.shows_ring) draw_focus_ring(canvas, ui.theme(), row, radius::control);
  canvas.icon({is_rail ? row.mid_x() : row.x + 20.0F, row.mid_y()}, Icon::Help, IconSize::Control,
              ui.theme().text_caption);
  if (!is_rail) {
    canvas.text_in({row.x + 42.0F, row.y, row.w - 90.0F, row.h},
                   {Type::Body, ui.theme().text_secondary}, label);
    key_chip(ui, {row.right() - 8.0F - key_chip_width(ui, "F1"), row.mid_y()}, "F1");
  }
  return response.is_pressed();
}

bool draw_person(Ui& ui, const Rect& row, const SignedIn& who, bool is_rail) {
  const Response response = navigation_row(ui, row, "nav.person", ui.text("navigation.person"));
  Canvas& canvas = ui.canvas();
  const Theme& theme = ui.theme();
  canvas.fill(row, faded(theme.raise, response.hover), radius::control);
  if (response.shows_ring) draw_focus_ring(canvas, theme, row, radius::control);
  avatar(ui, {is_rail ? row.mid_x() : row.x + 24.0F, row.mid_y()}, 16.0F, who.initials, who.hue);
  if (is_rail) {
    tooltip_when_resting(ui, "nav.person", row, who.name);
    return response.is_pressed();
  }
  const float room = row.w - 50.0F - 28.0F;
  canvas.text_in({row.x + 50.0F, row.mid_y() - 18.0F, room, 20.0F}, {Type::SmallMedium, theme.text},
                 who.name, true);
  canvas.text_in({row.x + 50.0F, row.mid_y(), room, 18.0F}, {Type::Caption, theme.text_caption},
                 who.role, true);
  canvas.icon({row.right() - 10.0F, row.mid_y()}, Icon::More, IconSize::Control,
              theme.text_caption);
  return response.is_pressed();
}

}  // namespace

bool wants_rail(const Ui& ui) noexcept { return ui.display().w < narrow; }
float navigation_width(const Ui& ui, bool is_rail) noexcept {
  return is_rail || wants_rail(ui) ? space::rail : space::side_navigation;
}

Rect navigation_gap(const Ui& ui, std::size_t items, bool is_rail) noexcept {
  if (is_rail || wants_rail(ui)) return {};
  const Rect display = ui.display();
  const float top = first_row + step_of(display, items) * static_cast<float>(items) + gap_edge;
  const float bottom = display.h - help_above_foot - gap_edge;
  return {side_inset, top, space::side_navigation - 2.0F * side_inset,
          std::max(0.0F, bottom - top)};
}

NavigationResponse side_navigation(Ui& ui, const NavigationSpec& spec) {
  const bool is_rail = spec.is_rail || wants_rail(ui);
  const Rect display = ui.display();
  const float width = navigation_width(ui, is_rail);
  Canvas& canvas = ui.canvas();
  canvas.fill({0.0F, 0.0F, width, display.h}, ui.theme().side);
  canvas.hairline_down(width - 1.0F, 0.0F, display.h, ui.theme().line);
  draw_logo(canvas, ui.theme(), {is_rail ? width / 2.0F : 36.0F, 36.0F}, 11.0F);
  if (!is_rail)
    canvas.text_on_baseline({58.0F, 42.0F}, {Type::CardTitle, ui.theme().text},
                            ui.text("product.name"));
  NavigationResponse response;
  const float step = step_of(display, spec.items.size());
  const Rect row{side_inset, 0.0F, width - 2.0F * side_inset, std::min(row_height, step - 2.0F)};
  for (std::size_t number = 0; number < spec.items.size(); ++number) {
    const Rect place = moved(row, 0.0F, first_row + step * static_cast<float>(number));
    if (draw_item(ui, place, spec.items[number], spec.chosen == static_cast<int>(number), is_rail))
      response = {NavigationAction::Item, static_cast<int>(number), {}};
  }
  if (draw_help(ui, {row.x, display.h - help_above_foot, row.w, row_height}, is_rail))
    response.action = NavigationAction::Help;
  if (!is_rail) canvas.hairline_across(side_inset, display.h - 84.0F, row.w, ui.theme().line);
  response.person = {row.x, display.h - 70.0F, row.w, 52.0F};
  if (draw_person(ui, response.person, spec.who, is_rail))
    response.action = NavigationAction::Person;
  return response;
}

}  // namespace hallux::ui
