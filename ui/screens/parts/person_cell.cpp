#include "ui/screens/parts/person_cell.h"

#include "ui/screens/parts/value_text.h"
#include "ui/widgets/controls/marks.h"

namespace hallux::ui {

void person_avatar(Ui& ui, Point centre, float radius, std::string_view name,
                   database::PersonId id) {
  avatar(ui, centre, radius, initials_of(name), static_cast<int>(id.number % 6));
}

void draw_person_cell(Ui& ui, const Rect& cell, const std::string& name, database::PersonId id) {
  person_avatar(ui, {cell.x + 14.0F, cell.mid_y()}, 14.0F, name, id);
  ui.canvas().text_in({cell.x + 38.0F, cell.y, cell.w - 38.0F, cell.h},
                      {Type::BodyMedium, ui.theme().text}, name, true);
}

}  // namespace hallux::ui
