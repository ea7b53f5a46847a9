/// Tables whose rows are values: one line a column says its head, what stands in its cells and how
/// rows are sorted by it.
///
///     const RowTable<Person> people{
///         ui.text("people.title"), &Person::login, &Person::display_name, {
///             {{ui.text("people.name"), 0.0F, 1.7F}, draw_name, {}, by(&Person::display_name)},
///             {{ui.text("people.login")}, &Person::login, plain_cell, by(&Person::login)}}};
///     const TableResponse response = table(ui, "people.row", rect, people, persons, state);
#pragma once

#include <algorithm>
#include <functional>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

#include "ui/widgets/controls/table.h"

namespace hallux::ui {

/// How the words of a cell look, in the column's alignment.
struct CellStyle {
  Type type = Type::Body;
  Color Theme::*color = &Theme::text_secondary;
};
inline constexpr CellStyle plain_cell{}, caption_cell{Type::Body, &Theme::text_caption},
    name_cell{Type::BodyMedium, &Theme::text}, small_cell{Type::Small, &Theme::text_secondary};

template <typename Row>
struct RowColumn {
  using Words = std::function<std::string(const Row&)>;
  using Drawing = std::function<void(Ui&, const Row&, const Rect&)>;

  /// Rows can be sorted by it where `before` is given.
  TableColumn place;
  /// What stands in a cell: words in `style`, or what draws itself.
  std::variant<Words, Drawing> cell;
  CellStyle style = {};
  std::function<bool(const Row&, const Row&)> before{};
};

template <typename Row>
struct RowTable {
  /// What the table lists.
  std::string_view label = {};
  /// The id of a row, stable while rows come and go.
  std::function<std::string(const Row&)> id;
  /// What a person would call the row.
  std::function<std::string(const Row&)> name;
  std::vector<RowColumn<Row>> columns;
  /// 36-48, where a row has one line.
  float row_height = 42.0F;
  /// Many may be chosen; else a press opens.
  bool has_checkboxes = false;
};

/// Words on the left may be shortened, what stands at the right (a number) may not.
inline void draw_cell_text(Ui& ui, const Rect& cell, Align align, const CellStyle& style,
                           std::string_view words) {
  ui.canvas().text_in(cell, {style.type, ui.theme().*style.color, align}, words,
                      align == Align::Left);
}

/// An order of rows by a key: a member, or a function of the row.
template <typename Key>
auto by(Key key) {
  return [key](const auto& a, const auto& b) { return std::invoke(key, a) < std::invoke(key, b); };
}

/// Rows may be held by value or by pointer.
template <typename Row, typename Item>
const Row& row_in(const Item& item) {
  if constexpr (std::is_same_v<std::remove_cv_t<Item>, Row>) {
    return item;
  } else {
    return *item;
  }
}

/// Sorts by the column that `sort` names; where it names none, by `otherwise`, and not at all where
/// that is none either.
template <typename Row, typename Rows>
void sort_rows(Rows& rows, const std::vector<RowColumn<Row>>& columns, const TableSort& sort,
               int otherwise = -1) {
  const int number = sort.column < 0 ? otherwise : sort.column;
  if (number < 0 || number >= static_cast<int>(columns.size())) return;
  const auto& before = columns[static_cast<std::size_t>(number)].before;
  std::stable_sort(rows.begin(), rows.end(), [&](const auto& a, const auto& b) {
    const Row &first = row_in<Row>(a), &second = row_in<Row>(b);
    return sort.is_descending ? before(second, first) : before(first, second);
  });
}

/// As `table` of a TableSpec; `rows` is any range with an index.
template <typename Row, typename Rows>
TableResponse table(Ui& ui, std::string_view id, const Rect& rect, const RowTable<Row>& shown,
                    const Rows& rows, TableState& state) {
  std::vector<TableColumn> places;
  for (const RowColumn<Row>& column : shown.columns) {
    places.push_back(column.place);
    places.back().can_sort = column.before != nullptr;
  }
  const auto at = [&](int row) -> const Row& {
    return row_in<Row>(rows[static_cast<std::size_t>(row)]);
  };
  TableSpec spec;
  spec.columns = places;
  spec.row_count = static_cast<int>(std::size(rows));
  spec.row_height = shown.row_height;
  spec.has_checkboxes = shown.has_checkboxes;
  spec.label = shown.label;
  spec.row_id = [&](int row) { return shown.id(at(row)); };
  spec.row_label = [&](int row) { return shown.name(at(row)); };
  spec.draw_cell = [&](Ui& own, int row, int number, const Rect& cell) {
    const RowColumn<Row>& column = shown.columns[static_cast<std::size_t>(number)];
    if (const auto* words = std::get_if<typename RowColumn<Row>::Words>(&column.cell)) {
      draw_cell_text(own, cell, column.place.align, column.style, (*words)(at(row)));
    } else {
      std::get<typename RowColumn<Row>::Drawing>(column.cell)(own, at(row), cell);
    }
  };
  return table(ui, id, rect, spec, state);
}

}  // namespace hallux::ui
