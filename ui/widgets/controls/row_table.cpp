#include "ui/widgets/controls/row_table.h"

namespace hallux::ui {

void draw_cell_text(Ui& ui, const Rect& cell, Align align, const CellStyle& style,
                    std::string_view words) {
  ui.canvas().text_in(cell, {style.type, ui.theme().*style.color, align}, words,
                      align == Align::Left);
}

}  // namespace hallux::ui
