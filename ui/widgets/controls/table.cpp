// A table laid out by what is in sight: rows and one beyond each edge, which an arrow must find.
// Columns share what fixed ones leave; those that say so go where the table is narrow, with their
// numbers kept. Choosing follows what people know from lists of files: Shift extends from an
// anchor, Ctrl+A takes all.
#include "ui/widgets/controls/table.h"

#include <cmath>
#include <vector>

#include "ui/widgets/controls/choice.h"
#include "ui/widgets/controls/tooltip.h"
#include "ui/widgets/shapes.h"

namespace hallux::ui {
namespace {

constexpr float head_height = 40.0F, checkbox_room = 34.0F, column_gap = 16.0F, row_reach = 12.0F;

/// A column that is not left out, and its part of a line.
struct ColumnPlace {
  int number = 0;
  Rect rect;
};

std::vector<ColumnPlace> columns_of(const Rect& line, const TableSpec& spec) {
  float left = line.x + (spec.has_checkboxes ? checkbox_room : 0.0F);
  float fixed = -column_gap, shares = 0.0F;
  for (const TableColumn& column : spec.columns) {
    if (line.w < column.from_width) continue;
    fixed += column.width + column_gap;
    if (column.width <= 0.0F) shares += column.share;
  }
  const float room = std::max(0.0F, line.right() - left - fixed);
  std::vector<ColumnPlace> places;
  for (std::size_t number = 0; number < spec.columns.size(); ++number) {
    const TableColumn& column = spec.columns[number];
    if (line.w < column.from_width) continue;
    const float width =
        column.width > 0.0F ? column.width : room * column.share / std::max(shares, 0.001F);
    places.push_back({static_cast<int>(number), {left, line.y, width, line.h}});
    left += width + column_gap;
  }
  return places;
}

/// What the column had no room for, once the pointer rests on the head or the keyboard stands
/// there.
void say_whole_head(Ui& ui, const std::string& control, const Rect& place, std::string_view head,
                    bool is_steered_to) {
  const Rect under{place.x, place.mid_y() - 14.0F, place.w, 28.0F};
  if (is_steered_to)
    tooltip(ui, {under.mid_x(), under.bottom()}, head, {});
  else
    tooltip_when_resting(ui, control, under, head);
}

bool draw_head(Ui& ui, std::string_view id, const Rect& place, const TableColumn& column,
               int number, TableSort& sort) {
  Canvas& canvas = ui.canvas();
  const Theme& theme = ui.theme();
  const bool is_sorted = sort.column == number;
  Response response;
  if (column.can_sort) {
    Widget widget{.id = std::string(id) + ".sort." + std::to_string(number),
                  .label = std::string(column.head),
                  .rect = {place.x - 6.0F, place.mid_y() - 14.0F, place.w + 12.0F, 28.0F}};
    const Rect rect = widget.rect;
    response = ui.control(std::move(widget));
    if (response.shows_ring) draw_focus_ring(canvas, theme, inset(rect, 3.0F), radius::step);
  }
  const Color ink =
      is_sorted ? theme.text_secondary : mixed(theme.text_caption, theme.text, response.hover);
  const bool is_right = column.align == Align::Right;
  const Rect room{place.x, place.y, place.w - (is_sorted && !is_right ? 16.0F : 0.0F), place.h};
  const float width = canvas.text_in(room, {Type::Caption, ink, column.align}, column.head, true);
  if (column.can_sort && canvas.width_of(Type::Caption, column.head) > room.w)
    say_whole_head(ui, std::string(id) + ".sort." + std::to_string(number), place, column.head,
                   response.shows_ring);
  if (is_sorted)
    canvas.icon({is_right ? place.right() - width - 10.0F : place.x + width + 10.0F, place.mid_y()},
                sort.is_descending ? Icon::SortDown : Icon::SortUp, IconSize::Inline,
                theme.text_secondary);
  if (!response.is_pressed()) return false;
  sort = {number, is_sorted && !sort.is_descending};
  return true;
}

// Rows from the anchor to `row` become the choice.
void extend_choice(const TableSpec& spec, TableState& state, int row) {
  int anchor = row;
  for (int other = 0; other < spec.row_count; ++other)
    if (spec.row_id(other) == state.anchor) anchor = other;
  state.chosen.clear();
  for (int other = std::min(anchor, row); other <= std::max(anchor, row); ++other)
    state.chosen.insert(spec.row_id(other));
}

void flip_choice(TableState& state, const std::string& row) {
  if (state.chosen.erase(row) == 0) state.chosen.insert(row);
  state.anchor = row;
}

struct RowPlace {
  int row = 0;
  Rect rect;
  std::string id;  ///< of the row alone
  bool is_chosen = false, is_joined_above = false, is_joined_below = false;
};

void draw_row_ground(Ui& ui, const RowPlace& place, const TableSpec& spec,
                     const Response& response) {
  Canvas& canvas = ui.canvas();
  const Theme& theme = ui.theme();
  const Rect ground = inset(place.rect, -row_reach, 0.0F);
  if (place.is_chosen) {
    const bool up = place.is_joined_above, down = place.is_joined_below;
    const Corners corners = up && down ? Corners::None
                            : up       ? Corners::Bottom
                            : down     ? Corners::Top
                                       : Corners::All;
    canvas.fill(ground, theme.accent_soft, radius::row, corners);
    if (up)
      canvas.hairline_across(place.rect.x, place.rect.y, place.rect.w, faded(theme.accent, 0.22F));
  } else {
    canvas.fill(ground, faded(theme.raise, response.hover), radius::row);
    if (!place.is_joined_below && place.row + 1 < spec.row_count)
      canvas.hairline_across(place.rect.x, place.rect.bottom() - 1.0F, place.rect.w, theme.line);
  }
  if (response.shows_ring) draw_focus_ring(canvas, theme, inset(ground, 3.0F, 4.0F), radius::row);
}

void react(Ui& ui, const TableSpec& spec, TableState& state, const RowPlace& place,
           const Response& response, TableResponse& answer) {
  const bool is_extending = ui.focus_was_extended() && response.has_focus;
  if (response.pressed_by == PressedBy::Enter || response.is_double ||
      (response.is_pressed() && !spec.has_checkboxes)) {
    answer.opened = place.row;
  } else if (is_extending || (response.is_pressed() && ui.modifiers().shift)) {
    if (state.anchor.empty()) state.anchor = place.id;
    extend_choice(spec, state, place.row);
    answer.has_choice_changed = true;
  } else if (response.is_pressed()) {
    flip_choice(state, place.id);
    answer.has_choice_changed = true;
  } else if (response.has_focus && !ui.modifiers().shift) {
    state.anchor = place.id;
  }
}

void draw_one_row(Ui& ui, std::string_view id, const TableSpec& spec, TableState& state,
                  const RowPlace& place, TableResponse& answer) {
  const Response response =
      ui.control({.id = std::string(id) + "." + place.id,
                  .label = std::string(spec.row_label ? spec.row_label(place.row) : place.id),
                  .rect = inset(place.rect, -row_reach, 0.0F),
                  .role = Role::Row,
                  .is_chosen = place.is_chosen,
                  .group = std::string(id)});
  draw_row_ground(ui, place, spec, response);
  react(ui, spec, state, place, response, answer);
  if (spec.has_checkboxes)
    draw_checkbox(ui, {place.rect.x, place.rect.mid_y() - 9.0F, 18.0F, 18.0F}, place.is_chosen,
                  true, {});
  for (const ColumnPlace& cell : columns_of(place.rect, spec)) {
    ui.canvas().push_room(inset(cell.rect, -1.0F, 0.0F));
    spec.draw_cell(ui, place.row, cell.number, cell.rect);
    ui.canvas().pop_room();
  }
}

void draw_rows(Ui& ui, std::string_view id, const Rect& view, const TableSpec& spec,
               TableState& state, TableResponse& answer) {
  const Rect scrolled = inset(view, -row_reach, 0.0F);
  const float height = spec.row_height * static_cast<float>(spec.row_count);
  const float offset = ui.begin_scroll(std::string(id) + ".rows", spec.label, scrolled, height);
  // One row beyond each edge is laid out too, so that an arrow finds it.
  const int first = std::max(0, static_cast<int>(std::floor(offset / spec.row_height)) - 1);
  const int last = std::min(spec.row_count,
                            static_cast<int>(std::ceil((offset + view.h) / spec.row_height)) + 1);
  const auto is_chosen = [&](int row) {
    return row >= 0 && row < spec.row_count && state.chosen.contains(spec.row_id(row));
  };
  for (int row = first; row < last; ++row) {
    RowPlace place;
    place.row = row;
    place.rect = {view.x, view.y - offset + spec.row_height * static_cast<float>(row), view.w,
                  spec.row_height};
    place.id = spec.row_id(row);
    place.is_chosen = is_chosen(row);
    place.is_joined_above = is_chosen(row - 1);
    place.is_joined_below = is_chosen(row + 1);
    draw_one_row(ui, id, spec, state, place, answer);
  }
  ui.end_scroll();
}

}  // namespace

TableResponse table(Ui& ui, std::string_view id, const Rect& rect, const TableSpec& spec,
                    TableState& state) {
  TableResponse answer;
  Rect rest = rect;
  const Rect head = take_top(rest, head_height);
  if (spec.has_checkboxes && spec.row_count > 0) {
    bool is_all = static_cast<int>(state.chosen.size()) == spec.row_count;
    const bool is_flipped =
        checkbox(ui, std::string(id) + ".all", {head.x, head.mid_y() - 9.0F, 18.0F, 18.0F},
                 ui.text("table.choose_all"), is_all, false);
    if (is_flipped || ui.shortcut(with_control(Key::A), ui.text("table.choose_all"))) {
      const bool chooses = is_flipped ? is_all : true;
      state.chosen.clear();
      for (int row = 0; chooses && row < spec.row_count; ++row)
        state.chosen.insert(spec.row_id(row));
      answer.has_choice_changed = true;
    }
  }
  for (const ColumnPlace& place : columns_of(head, spec)) {
    const TableColumn& column = spec.columns[static_cast<std::size_t>(place.number)];
    answer.has_sort_changed |= draw_head(ui, id, place.rect, column, place.number, state.sort);
  }
  ui.canvas().hairline_across(head.x, head.bottom() - 1.0F, head.w, ui.theme().line);
  draw_rows(ui, id, rest, spec, state, answer);
  if (answer.opened || answer.has_sort_changed || answer.has_choice_changed)
    ui.want_frame_in_s(0.0);
  return answer;
}

int action_bar(Ui& ui, std::string_view id, const Rect& rect, std::string_view chosen,
               std::span<const std::string_view> actions, std::string_view right) {
  Canvas& canvas = ui.canvas();
  canvas.fill(rect, ui.theme().raise, radius::control);
  float x = rect.x + 14.0F;
  x += canvas.text({x, rect.mid_y()}, {Type::SmallMedium, ui.theme().text}, chosen) + 28.0F;
  int pressed = -1;
  for (std::size_t number = 0; number < actions.size(); ++number) {
    if (link(ui, std::string(id) + "." + std::to_string(number), {x, rect.mid_y()},
             actions[number]))
      pressed = static_cast<int>(number);
    x += ui.width_of(Type::Small, actions[number]) + 28.0F;
  }
  canvas.text({rect.right() - 14.0F, rect.mid_y()},
              {Type::Small, ui.theme().text_secondary, Align::Right}, right);
  return pressed;
}

}  // namespace hallux::ui
