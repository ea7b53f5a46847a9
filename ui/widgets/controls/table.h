/// Rows with columns: choose one or many, sort by a head, open by Enter or a double click. A narrow
/// table leaves out the columns that say so. Inside this corner only.
///
/// Only what is in sight is laid out, so a table may have a hundred thousand rows. Arrows move,
/// Space chooses, Shift+arrows extend, Enter opens, Ctrl+A chooses all. The row with the focus
/// stays in sight.
#pragma once

#include <functional>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>

#include "ui/widgets/ui.h"

namespace hallux::ui {

struct TableColumn {
  std::string_view head = {};
  /// Logical pixels; 0: a share of what the others leave, by `share`.
  float width = 0.0F;
  float share = 1.0F;
  /// Numbers right, words left.
  Align align = Align::Left;
  /// Where the table is narrower the column is left out. The numbers of the others stay: in the
  /// sort, in `draw_cell` and in ids.
  float from_width = 0.0F;
  bool can_sort = false;
};

struct TableSort {
  int column = -1;
  bool is_descending = false;
};

/// What a table remembers between frames; owned by the screen.
struct TableState {
  /// Ids of rows.
  std::set<std::string> chosen;
  /// Where Shift extends from.
  std::string anchor = {};
  TableSort sort;
};

struct TableSpec {
  std::span<const TableColumn> columns = {};
  int row_count = 0;
  /// 36-48.
  float row_height = 42.0F;
  /// Many may be chosen; else a press opens.
  bool has_checkboxes = false;
  /// What the table lists.
  std::string_view label = {};
  /// The id of a row, stable while rows come and go: "trainee-02". It becomes `id.row_id` of the
  /// control.
  std::function<std::string(int row)> row_id;
  /// What a person would call the row.
  std::function<std::string(int row)> row_label;
  /// Draws one cell inside `cell`, of a column that is not left out.
  std::function<void(Ui& ui, int row, int column, const Rect& cell)> draw_cell;
};

struct TableResponse {
  /// Row.
  std::optional<int> opened;
  bool has_sort_changed = false;
  bool has_choice_changed = false;
};

/// Head 40 high, then the rows, which scroll inside `rect`.
TableResponse table(Ui& ui, std::string_view id, const Rect& rect, const TableSpec& spec,
                    TableState& state);

/// What can be done with the chosen rows, 40 high at the table's foot: "2 chosen", the actions as
/// links named `id.0`, `id.1` ..., and a text at the right. Returns the action pressed, -1 none.
int action_bar(Ui& ui, std::string_view id, const Rect& rect, std::string_view chosen,
               std::span<const std::string_view> actions, std::string_view right);

}  // namespace hallux::ui
